// Layers around the axis, one inside the other, that must not cross.
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

/// The layers of a drawing by how far out they lie, and what keeps any two apart.
struct Layers {
  std::vector<std::size_t> surface;        ///< index into Template::surfaces, outermost first
  std::vector<std::vector<LayerGap>> gap;  ///< [i][j]: the condition under which layer i does not cross layer j
};

/// The layers of all surfaces around the axis that have a loop.
Layers layers_of(const Template& fruit);

/// Swells with which the layers do not cross: each swell moves towards that of the next layer outside as far as
/// necessary, with a gradual change around such places. swells[i] belongs to layer i; the azimuths are the same for all
/// layers. Layers marked `fixed` do not move.
std::vector<std::vector<double>> kept_apart(const Layers& layers, std::vector<std::vector<double>> swells,
                                            const std::vector<bool>& fixed);

/// True if no two layers cross at any of the azimuths.
bool are_apart(const Layers& layers, const std::vector<std::vector<double>>& swells);

}  // namespace pomona
