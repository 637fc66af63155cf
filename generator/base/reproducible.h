// Elementary functions whose bits do not depend on the processor, the compiler or its options.
// The functions of the C library differ between processors, because it picks fused variants at run time. So nothing
// that ends up in a file may call std::sin and the like. These are SLEEF's "cinz" functions: plain C, no fused
// operations, errors within 1 unit in the last place.
#pragma once

#include <array>

namespace pomona::reproducible {

double sin(double radians);
double cos(double radians);
double atan2(double y, double x);
double acos(double x);
double exp(double x);
double log(double x);
double pow(double base, double exponent);
double cbrt(double x);

/// Four roots at once, with the same bits as one by one, in half the time.
std::array<double, 4> cbrt(const std::array<double, 4>& x);

}  // namespace pomona::reproducible
