// How much more one layer may swell than another before the surfaces swept from them cross.
#pragma once

#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// A layer's swell at an azimuth is its loop's radius over the reference radius: what its vertical curve is scaled by
/// there (less where roundness fades it). These are the swells at each azimuth.
std::vector<double> swells(const Curve& loop, double reference, const std::vector<double>& azimuths);

struct SwellRange {
  double low = 0;
  double high = 1e9;
};

/// What keeps layer `a` from crossing layer `b`. In the half-plane of one azimuth both vertical curves are those of the
/// drawing, moved along the radius alone, so they first touch where a corner of one meets the other at
/// its own height. A variant keeps some way off such touches, or as far as the drawing does. Layers that
/// cross as drawn do not hinder each other.
class LayerGap {
 public:
  LayerGap() = default;
  LayerGap(const SurfaceSketch& a, const SurfaceSketch& b);

  /// What the swell of `a` may be where `b` has this one.
  SwellRange room(double swell_b) const;

  /// The same with `a` and `b` exchanged.
  LayerGap inverted() const;

 private:
  /// A height at which the curves touch when the swell of a over that of b comes to `ratio`, where of each layer's
  /// swell only a share shows.
  struct Touch {
    double ratio = 1;
    double share_a = 1, share_b = 1;
  };

  void leave_margin(const SurfaceSketch& a, const SurfaceSketch& b);

  std::vector<Touch> above_;  ///< a must not swell more
  std::vector<Touch> below_;  ///< a must not swell less
};

/// Area enclosed with the axis: how far out a layer lies among others that do not cross it. Square metres.
double area_to_axis(const Curve& vertical);

}  // namespace pomona
