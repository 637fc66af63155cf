// Elementary functions whose bits do not depend on the processor, the compiler or its options.
// The C library's differ between processors (it picks fused variants at run time), so nothing that ends
// up in a file may call std::sin and its kin. These are SLEEF's "cinz" functions: plain C, no fused
// operations, within 1 unit in the last place.
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

/// Four at once, each with the bits that it has alone, in half the time.
std::array<double, 4> cbrt(const std::array<double, 4>& x);

}  // namespace pomona::reproducible
