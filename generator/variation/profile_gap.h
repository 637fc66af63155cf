// How much more one layer may swell than another before the surfaces swept from them cross.
#pragma once

#include "generator/template/template.h"

namespace pomona {

/// Logarithms of ratios; low <= 0 <= high unless something crosses as drawn.
struct LogRange {
  double low = 0;
  double high = 0;
};

/// Sweeping scales a vertical curve along the radius by its loop's radius over the reference radius. In the
/// half-plane of one azimuth the two curves therefore differ from the drawing by one factor each, and only
/// the ratio of the two matters. The result is the range of log(factor of `a` / factor of `b`) in which the
/// curves stay apart, found from the radii at equal heights; unbounded if they cross as drawn.
LogRange free_log_ratio(const Curve& a, const Curve& b);

/// Area enclosed with the axis: how far out a layer lies among others that do not cross it. Square metres.
double area_to_axis(const Curve& vertical);

/// Log of the loop's outermost radius over the reference radius, at every azimuth.
std::vector<double> log_shape(const Curve& loop, double reference, const std::vector<double>& azimuths);

/// The range in which two layers may differ in a variant: a margin inside the free range, but whatever the
/// drawing has itself. `shape_a` and `shape_b` are the drawn log shapes at equal azimuths.
LogRange allowed_log_ratio(const SurfaceSketch& a, const SurfaceSketch& b, const std::vector<double>& shape_a,
                           const std::vector<double>& shape_b);

}  // namespace pomona
