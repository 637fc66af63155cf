#include "generator/base/many_values.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif
#include <sleef.h>

#include "generator/base/reproducible.h"

#ifdef __SSE2__
// SLEEF's header shows these only to sources that are compiled for such processors alone.
extern "C" {
__attribute__((target("avx"))) __m256d Sleef_cinz_cbrtd4_u10avx(__m256d);
__attribute__((target("avx"))) __m256d Sleef_cinz_expd4_u10avx(__m256d);
__attribute__((target("avx"))) __m256d Sleef_cinz_atan2d4_u10avx(__m256d, __m256d);
__attribute__((target("avx512f"))) __m512d Sleef_cinz_cbrtd8_u10avx512fnofma(__m512d);
__attribute__((target("avx512f"))) __m512d Sleef_cinz_expd8_u10avx512fnofma(__m512d);
__attribute__((target("avx512f"))) __m512d Sleef_cinz_atan2d8_u10avx512fnofma(__m512d, __m512d);
}
#endif

namespace pomona {

VectorWidth widest_vectors() {
#ifdef __SSE2__
  static const VectorWidth known = __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")
                                       ? VectorWidth::eight
                                   : __builtin_cpu_supports("avx2") ? VectorWidth::four
                                                                    : VectorWidth::plain;
  return known;
#else
  return VectorWidth::plain;
#endif
}

namespace reproducible {

namespace {

enum class Function { exponential, cube_root };

double one(Function function, double x) {
  return function == Function::exponential ? reproducible::exp(x) : reproducible::cbrt(x);
}

#ifdef __SSE2__
// Whole vectors of `count` values.
__attribute__((target("avx"))) void fours(Function function, const double* x, double* value, std::size_t count) {
  for (std::size_t i = 0; i + 4 <= count; i += 4) {
    const __m256d at = _mm256_loadu_pd(x + i);
    _mm256_storeu_pd(value + i,
                     function == Function::exponential ? Sleef_cinz_expd4_u10avx(at) : Sleef_cinz_cbrtd4_u10avx(at));
  }
}

__attribute__((target("avx512f"))) void eights(Function function, const double* x, double* value, std::size_t count) {
  for (std::size_t i = 0; i + 8 <= count; i += 8) {
    const __m512d at = _mm512_loadu_pd(x + i);
    _mm512_storeu_pd(value + i, function == Function::exponential ? Sleef_cinz_expd8_u10avx512fnofma(at)
                                                                  : Sleef_cinz_cbrtd8_u10avx512fnofma(at));
  }
}

__attribute__((target("avx"))) void four_turns(const double* y, const double* x, double* value, std::size_t count) {
  for (std::size_t i = 0; i + 4 <= count; i += 4)
    _mm256_storeu_pd(value + i, Sleef_cinz_atan2d4_u10avx(_mm256_loadu_pd(y + i), _mm256_loadu_pd(x + i)));
}

__attribute__((target("avx512f"))) void eight_turns(const double* y, const double* x, double* value,
                                                    std::size_t count) {
  for (std::size_t i = 0; i + 8 <= count; i += 8)
    _mm512_storeu_pd(value + i, Sleef_cinz_atan2d8_u10avx512fnofma(_mm512_loadu_pd(y + i), _mm512_loadu_pd(x + i)));
}
#endif

/// How many of `count` values fill whole vectors.
std::size_t in_vectors([[maybe_unused]] VectorWidth width, [[maybe_unused]] std::size_t count) {
#ifdef __SSE2__
  if (width == VectorWidth::eight) return count / 8 * 8;
  if (width == VectorWidth::four) return count / 4 * 4;
#endif
  return 0;
}

std::vector<double> each(Function function, std::span<const double> x, VectorWidth width) {
  std::vector<double> value(x.size());
#ifdef __SSE2__
  if (width == VectorWidth::eight) eights(function, x.data(), value.data(), x.size());
  if (width == VectorWidth::four) fours(function, x.data(), value.data(), x.size());
#endif
  for (std::size_t i = in_vectors(width, x.size()); i < x.size(); ++i) value[i] = one(function, x[i]);
  return value;
}

}  // namespace

std::vector<double> exponentials(std::span<const double> x, VectorWidth width) {
  return each(Function::exponential, x, width);
}

std::vector<double> cube_roots(std::span<const double> x, VectorWidth width) {
  return each(Function::cube_root, x, width);
}

std::vector<double> azimuths(std::span<const double> y, std::span<const double> x, VectorWidth width) {
  std::vector<double> value(x.size());
#ifdef __SSE2__
  if (width == VectorWidth::eight) eight_turns(y.data(), x.data(), value.data(), x.size());
  if (width == VectorWidth::four) four_turns(y.data(), x.data(), value.data(), x.size());
#endif
  for (std::size_t i = in_vectors(width, x.size()); i < x.size(); ++i) value[i] = reproducible::atan2(y[i], x[i]);
  return value;
}

}  // namespace reproducible

}  // namespace pomona
