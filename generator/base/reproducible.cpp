#include "generator/base/reproducible.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif
#include <sleef.h>

#ifdef __SSE2__
// SLEEF's header shows this only to sources that are compiled for such processors alone.
extern "C" __attribute__((target("avx"))) __m256d Sleef_cinz_cbrtd4_u10avx(__m256d);
#endif

namespace pomona::reproducible {

double sin(double radians) { return Sleef_cinz_sind1_u10purec(radians); }
double cos(double radians) { return Sleef_cinz_cosd1_u10purec(radians); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double acos(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double log(double x) { return Sleef_cinz_logd1_u10purec(x); }
double pow(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }
double cbrt(double x) { return Sleef_cinz_cbrtd1_u10purec(x); }

#ifdef __SSE2__
namespace {

__attribute__((target("avx"))) void wide_cbrt(const double* x, double* root) {
  _mm256_storeu_pd(root, Sleef_cinz_cbrtd4_u10avx(_mm256_loadu_pd(x)));
}

}  // namespace

std::array<double, 4> cbrt(const std::array<double, 4>& x) {
  static const bool has_avx = __builtin_cpu_supports("avx");
  std::array<double, 4> root{};
  if (has_avx) {
    wide_cbrt(x.data(), root.data());
  } else {
    _mm_storeu_pd(&root[0], Sleef_cinz_cbrtd2_u10sse2(_mm_loadu_pd(&x[0])));
    _mm_storeu_pd(&root[2], Sleef_cinz_cbrtd2_u10sse2(_mm_loadu_pd(&x[2])));
  }
  return root;
}
#else
// Other processors have pairs of other kinds; one root has the bits of its pair.
std::array<double, 4> cbrt(const std::array<double, 4>& x) { return {cbrt(x[0]), cbrt(x[1]), cbrt(x[2]), cbrt(x[3])}; }
#endif

}  // namespace pomona::reproducible
