// Layers around the axis, one inside the other, that must not cross.
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
    double ratio = 1;
    double share_a = 1, share_b = 1;
  };

  void leave_margin(const SurfaceSketch& a, const SurfaceSketch& b);

  std::vector<Touch> above_;  ///< upper limits of the swell of a
  std::vector<Touch> below_;  ///< lower limits of the swell of a
};

/// The area between the curve and the axis, square metres. It sorts layers that do not cross from inside to outside.
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
