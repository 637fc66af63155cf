// Grains of a template: seeds and the like, strewn over a surface.
#pragma once

#include <string>
#include <vector>

#include "generator/template/side.h"

namespace pomona {

/// Where on their surface grains grow, and how densely.
struct GrainGround {
  double along_from = 0, along_to = 1;    ///< the band of the vertical curve
  double around_from = 0, around_to = 1;  ///< the stretch of the horizontal curve; from > to runs through its start
  double depth_from = 0, depth_to = 1;  ///< in folds: between the vertical curve's inner arc (0) and its outer one (1)
  std::vector<int> folds;               ///< only in these, from 0; empty = in all
  enum class Facing { any, towards_axis, from_axis } facing = Facing::any;  ///< only where they point this way

  /// Grains per area as a share of a full surface's, 0..1: along times around. Below 0.01 none grow. The spacing
  /// is the Poisson radius over the square root of this.
  Ramp<double> density_along = Ramp<double>::constant(1);
  Ramp<double> density_around = Ramp<double>::constant(1);

  double share = 1;       ///< of the places taken, those where there is a grain at last
  double fold_share = 1;  ///< of the folds, those with any grains
};

/// What keeps grains apart.
struct GrainSpacing {
  double poisson_radius = 0;    ///< metres: two centres are no nearer than the mean of both grains' spacings
  bool any_facing = false;      ///< also if they face different ways
  std::vector<int> apart_from;  ///< earlier ones of Template::grains whose centres keep the same distance
  bool solid = false;           ///< no two ellipsoids in which the grains lie overlap, nor with those of `apart_from`
};

/// What one grain is formed like before it is stretched to its sizes.
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
  double pointedness = 0;                       ///< 0 = as the shape is, 1 = a drop with its tip at the +length end
  double length = 0, width = 0, thickness = 0;  ///< full axes of the grain, metres
  double size_jitter = 0;                       ///< share, 0..0.9
  double length_jitter = 0, width_jitter = 0;   ///< shares beyond that, 0..0.9
  int around = 8, along = 6;
};

/// How grains lie.
struct GrainStance {
  enum class Heading { along, towards_axis, from_axis, up, down };
  enum class Flat { surface, around, up };

  double sink = 0;                   ///< how deep the centre lies below the surface, metres (negative = above)
  Heading heading = Heading::along;  ///< where the tip points: up the vertical curve within the surface, or as said
  Flat flat = Flat::surface;         ///< what the flat side faces, as nearly as the heading lets it
  double angle = 0;                  ///< radians, a turn about the flat side's normal
  double angle_jitter = 0;           ///< radians, to either side
  double tilt = 0;                   ///< radians, of the tip towards the flat side's normal
  double tilt_jitter = 0;            ///< radians, to either side
};

/// Colours some grains have instead of their own: unripe ones, empty ones.
struct GrainLook {
  double share = 0;  ///< of the grains
  double scale = 1;  ///< of their size
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

/// Grains (seeds) scattered by dart throwing over one surface (paper, section 4, step 2).
struct GrainSketch {
  std::string name;
  int surface = 0;       ///< index into Template::surfaces
  bool on_front = true;  ///< which side they sit on and point away from
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
