// How much one layer may swell more than another before the surfaces swept from them cross.
#pragma once

#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// The swell of a layer at each azimuth: the radius of its loop divided by the reference radius. Its vertical curve is
/// scaled by this factor (less where roundness reduces it).
std::vector<double> swells(const Curve& loop, double reference, const std::vector<double>& azimuths);

struct SwellRange {
  double low = 0;
  double high = 1e9;
};

/// The condition under which layer `a` does not cross layer `b`. In the half-plane of one azimuth, both vertical curves
/// are those of the drawing, moved only along the radius. So they first touch where a corner of one meets the other at
/// the same height. A variant keeps a distance from such touches, or that of the drawing if it is smaller. There is no
/// condition for layers that cross in the drawing.
class LayerGap {
 public:
  LayerGap() = default;
  LayerGap(const SurfaceSketch& a, const SurfaceSketch& b);

  /// The range of swells of `a` that is allowed where `b` has this swell.
  SwellRange room(double swell_b) const;

  /// The same with `a` and `b` exchanged.
  LayerGap inverted() const;

 private:
  /// A height at which the curves may touch.
  struct Touch {
    double ratio = 1;                 ///< they touch if the swell of a is this times the swell of b
    double share_a = 1, share_b = 1;  ///< the share of each layer's swell that is effective at this height
  };

  void leave_margin(const SurfaceSketch& a, const SurfaceSketch& b);

  std::vector<Touch> above_;  ///< upper limits of the swell of a
  std::vector<Touch> below_;  ///< lower limits of the swell of a
};

/// The area between the curve and the axis, square metres. It sorts layers that do not cross from inside to outside.
double area_to_axis(const Curve& vertical);

}  // namespace pomona
