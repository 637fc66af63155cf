// Grains of a template: seeds and the like, scattered over a surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/template/grain_volume.h"
#include "generator/template/side.h"

namespace pomona {

/// The region of a surface where grains grow, and their density.
struct GrainGround {
  double along_from = 0, along_to = 1;    ///< band of the vertical curve, as shares
  double around_from = 0, around_to = 1;  ///< part of the horizontal curve, as shares; from > to runs through its start
  double depth_from = 0, depth_to = 1;  ///< in folds: between the vertical curve's inner arc (0) and its outer one (1)
  std::vector<int> folds;               ///< only in these, from 0; empty = in all
  enum class Facing { any, towards_axis, from_axis } facing = Facing::any;  ///< only where they point this way

  /// Grains per area relative to a full surface, 0..1: the product of `along` and `around`. Below 0.01 no grains grow.
  /// The spacing is the Poisson radius divided by the square root of this.
  Ramp<double> density_along = Ramp<double>::constant(1);
  Ramp<double> density_around = Ramp<double>::constant(1);

  double share = 1;       ///< share of the places that get a grain
  double fold_share = 1;  ///< share of the folds that have grains
};

/// The distances between grains.
struct GrainSpacing {
  std::optional<int> law;       ///< index into Template::laws: grains sit at its seats, and the rest does not count
  double poisson_radius = 0;    ///< metres: two centres are no nearer than the mean of both grains' spacings
  bool any_facing = false;      ///< also if they face different ways
  std::vector<int> apart_from;  ///< earlier ones of Template::grains whose centres keep the same distance
  std::vector<int> clear_of;    ///< surfaces whose walls no grain touches; a grain in the way moves, shrinks or goes
  bool solid = false;           ///< no two ellipsoids in which the grains lie overlap, nor with those of `apart_from`
};

/// The shape of a grain before it is scaled to its sizes.
enum class GrainShape {
  ellipsoid,
  lens,     ///< two caps that meet in a sharp rim
  disc,     ///< flat, with a narrow round rim
  rod,      ///< even, with blunt ends
  spindle,  ///< pointed at both ends
  bean,     ///< bent in the plane of length and width
  cushion,  ///< blunt, between ball and box
};

struct GrainForm {
  GrainShape shape = GrainShape::ellipsoid;
  double pointedness = 0;                         ///< 0 = the shape itself, 1 = a drop with its tip at the +length end
  double length = 0, width = 0, thickness = 0;    ///< full axes of the grain, metres
  Ramp<double> size = Ramp<double>::constant(1);  ///< factor of the sizes by the share of the surface's vertical curve
  double size_jitter = 0;                         ///< random variation of the size, as a share, 0..0.9
  double length_jitter = 0, width_jitter = 0;     ///< further random variation of length and width, as shares, 0..0.9
  int around = 8, along = 6;
};

/// The pose of grains.
struct GrainStance {
  enum class Heading { along, towards_axis, from_axis, up, down };
  enum class Flat { surface, around, up };

  double sink = 0;                   ///< how deep the centre lies below the surface, metres (negative = above)
  Heading heading = Heading::along;  ///< direction of the tip; `along` = up the vertical curve, in the surface
  Flat flat = Flat::surface;         ///< direction of the flat side, as far as the heading allows it
  double angle = 0;                  ///< rotation about the flat side's normal, radians
  double angle_jitter = 0;           ///< random part of `angle`, radians, to either side
  double tilt = 0;                   ///< tilt of the tip towards the flat side's normal, radians
  double tilt_jitter = 0;            ///< random part of `tilt`, radians, to either side
};

/// Another appearance of some grains, such as unripe or empty ones.
struct GrainLook {
  double share = 0;  ///< share of the grains that have it
  double scale = 1;  ///< factor of their size
  PaintedColor front;
  PaintedColor back;
};

/// A grain within each grain, of the same heading: the seed in an aril.
struct GrainCore {
  GrainForm form;    ///< sizes as shares of the grain's; no jitter
  double shift = 0;  ///< towards the tip, as a share of the grain's length
  Side front;
  Side back;
  double blur = 0;
};

/// Grains (seeds) over one surface: scattered by dart throwing (paper, section 4, step 2), or at the seats of a law.
/// Or grains inside of it.
struct GrainSketch {
  std::string name;
  std::optional<GrainVolume> volume = {};  ///< they fill the surface: ground, spacing and stance do not count, and
                                           ///< the form is that of the largest
  int surface = 0;                         ///< index into Template::surfaces
  bool on_front = true;                    ///< which side they sit on and point away from
  GrainGround ground;
  GrainSpacing spacing;
  GrainForm form;
  GrainStance stance;
  Side front;
  Side back;
  double blur = 0;
  double lightness_jitter = 0;  ///< OKLab, to either side
  double hue_jitter = 0;        ///< radians in OKLab, to either side
  std::vector<GrainLook> looks;
  std::vector<GrainCore> cores;
};

}  // namespace pomona
