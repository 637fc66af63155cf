#include "generator/base/reproducible.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif
#include <sleef.h>

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
std::array<double, 4> cbrt(const std::array<double, 4>& x) {
  std::array<double, 4> root{};
  _mm_storeu_pd(&root[0], Sleef_cinz_cbrtd2_u10sse2(_mm_loadu_pd(&x[0])));
  _mm_storeu_pd(&root[2], Sleef_cinz_cbrtd2_u10sse2(_mm_loadu_pd(&x[2])));
  return root;
}
#else
// Other processors have pairs of other kinds; one root has the bits of its pair.
std::array<double, 4> cbrt(const std::array<double, 4>& x) { return {cbrt(x[0]), cbrt(x[1]), cbrt(x[2]), cbrt(x[3])}; }
#endif

}  // namespace pomona::reproducible
