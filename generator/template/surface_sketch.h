// One drawn surface of a template.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/base/curve.h"
#include "generator/template/ramp.h"
#include "generator/template/side.h"

namespace pomona {

enum class SurfaceType {
  around_axis,  ///< Type I: surrounds the axis of symmetry.
  in_fold,      ///< Type II: lies within a single fold.
};

/// The radii of the horizontal drawing that the vertical curve stands for, metres. A sweep carries a horizontal
/// radius r at height v to rho = I(v) + (r - inner) / (outer - inner) * (O(v) - I(v)), also where r lies outside
/// [inner, outer]. O is the vertical curve's outer arc and I its inner one; around the axis I and `inner` are 0.
struct ReferenceRadii {
  double inner = 0;
  double outer = 0;
};

/// How far the middle of a surface's sections lies from the axis, metres, by the share of the vertical curve.
struct AxisOffset {
  Ramp<double> x = Ramp<double>::constant(0), z = Ramp<double>::constant(0);

  bool is_zero() const;
};

/// One drawn surface: a vertical and a horizontal curve (paper, section 4.1), in metres.
/// Vertical: x = distance from the axis, y = height. Horizontal, seen from above: x = +X, y = -Z, so that its
/// polar angle is the angle about the axis. Front is outside (away from the axis, out of a closed loop).
struct SurfaceSketch {
  std::string name;
  SurfaceType type = SurfaceType::around_axis;
  Curve vertical;                  ///< around_axis: open, bottom to top; in_fold: closed
  std::vector<Curve> horizontal;   ///< around_axis: one closed loop, or one for each of `stops`; in_fold: one per
                                   ///< fold (empty = none there)
  std::vector<double> stops = {};  ///< around_axis: where along the vertical curve each of several loops is, ascending;
                                   ///< the loops have the same reference radius, and blend between
  std::optional<double> reference_azimuth;  ///< azimuth at which the vertical curve was drawn; else the loop's mean
                                            ///< radius counts
  std::optional<ReferenceRadii> reference;  ///< set in variants: those of the drawing, so that they keep its scale
  AxisOffset off = {};                      ///< around_axis
  Ramp<double> roundness = Ramp<double>::constant(0);  ///< along: 0 = the loop as drawn, 1 = a circle
  double taper = 0.5;                                  ///< in_fold: exponent p of the closing at the ends
  Side front;
  Side back;
  PaintedBlur blur;
  int around = 96;  ///< vertices around the axis (in an N-fold fruit: rounded to a multiple of N), or per loop
  int along = 48;   ///< vertices along the vertical curve
  bool varies = true;
  bool guide = true;  ///< whether texture details find their way by it (generator/piece/guided.h)
};

/// The surface's `reference` if set. Else, around the axis: the loop's radius at the reference azimuth, or its mean;
/// in folds: least and largest radius of the loop nearest to the reference azimuth, or their means over all loops.
ReferenceRadii reference_radii(const SurfaceSketch& surface);

}  // namespace pomona
