// What a fruit is: plain data, as drawn or as varied. Reading it is read_template.h's business, sweeping
// it surface/sweep.h's, varying it variation/vary.h's.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/base/color.h"
#include "generator/base/curve.h"

namespace pomona {

/// Structures stay much the same after any turn around the axis (paper, section 4.1).
struct CylindricalSymmetry {};

/// N repetitive structures around the axis. Fold k spans [fold_angles[k], fold_angles[k + 1]), the last one
/// up to fold_angles[0] + 2 pi; radians, ascending, from +X towards -Z.
struct FoldSymmetry {
  std::vector<double> fold_angles;
};

using Symmetry = std::variant<CylindricalSymmetry, FoldSymmetry>;

/// Piecewise linear values over [0, 1]; constant outside its stops; never empty.
template <typename Value>
struct Ramp {
  struct Stop {
    double at = 0;
    Value value{};
  };
  std::vector<Stop> stops;

  static Ramp constant(const Value& value) { return {{{0.0, value}}}; }

  Value operator()(double t) const {
    if (t <= stops.front().at) return stops.front().value;
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Stop& a = stops[i - 1];
      const Stop& b = stops[i];
      if (t < b.at) {
        const auto share = static_cast<float>((t - a.at) / (b.at - a.at));
        return static_cast<Value>(a.value + (b.value - a.value) * share);
      }
    }
    return stops.back().value;
  }
};

/// The colour of one side: `along` the vertical curve (0 = where it starts: bottom) times `around` the
/// horizontal one (0 = its start; white where nothing is said; repeated in every fold of an N-fold fruit).
struct PaintedColor {
  Ramp<Color> along;
  Ramp<Color> around = Ramp<Color>::constant(Color(1.0f));
};

/// One side of a surface. `part` indexes Template::parts. Hidden: the side faces air.
struct Side {
  int part = 0;
  PaintedColor color;
  bool hidden = false;
};

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

/// One drawn surface: a vertical and a horizontal curve (paper, section 4.1), in metres.
/// Vertical: x = distance from the axis, y = height. Horizontal, seen from above: x = +X, y = -Z, so that its
/// polar angle is the angle about the axis. Front is outside (away from the axis, out of a closed loop).
struct SurfaceSketch {
  std::string name;
  SurfaceType type = SurfaceType::around_axis;
  Curve vertical;                 ///< around_axis: open, bottom to top; in_fold: closed
  std::vector<Curve> horizontal;  ///< around_axis: one closed loop; in_fold: one per fold (empty = none there)
  std::optional<double> reference_azimuth;  ///< where the vertical curve was drawn; else the loop's mean radius
  std::optional<ReferenceRadii> reference;  ///< set in variants: those of the drawing, so that they keep its scale
  Ramp<double> roundness = Ramp<double>::constant(0);  ///< along: 0 = the loop as drawn, 1 = a circle
  double taper = 0.5;                                  ///< in_fold: exponent p of the closing at the ends
  Side front;
  Side back;
  Ramp<double> blur = Ramp<double>::constant(0);  ///< metres, along
  int around = 96;  ///< vertices around the axis (in an N-fold fruit: rounded to a multiple of N), or per loop
  int along = 48;   ///< vertices along the vertical curve
  bool varies = true;
};

/// Grains (seeds) scattered by dart throwing over one surface (paper, section 4, step 2).
struct GrainSketch {
  std::string name;
  int surface = 0;                              ///< index into Template::surfaces
  bool on_front = true;                         ///< which side they sit on and point away from
  double poisson_radius = 0;                    ///< metres: no two centres on surfaces facing the same way are nearer
  double length = 0, width = 0, thickness = 0;  ///< full axes of the grain, metres; length runs along the surface
  double sink = 0;                      ///< how deep its centre lies below the surface, metres (negative = above)
  double size_jitter = 0;               ///< share, 0..0.9
  double angle_jitter = 0;              ///< radians, about the normal
  double tilt = 0;                      ///< radians, of the tip away from the surface
  double pointedness = 0;               ///< 0 = ellipsoid, 1 = drop with its tip at the +length end
  double along_from = 0, along_to = 1;  ///< the band of the vertical curve they grow on
  Side front;
  Side back;
  double blur = 0;
  int around = 8, along = 6;
};

/// Perlin modulation keyed by the unmodulated colour (paper, section 5; docs/style.md).
struct NoiseKey {
  Color color;
  std::vector<double> weights;  ///< one per band, OKLab units
  glm::vec3 axis{1, 0, 0};      ///< OKLab direction of the modulation
};

struct NoiseStyle {
  double base_frequency = 0;    ///< cycles per metre of the lowest band; each further band doubles it
  glm::dvec3 stretch{1, 1, 1};  ///< frequencies times this along radius, height, azimuth: 1,1,1 = isotropic in x,y,z
  double sigma = 0.12;          ///< OKLab distance over which a key fades
  std::vector<NoiseKey> keys;
};

/// How the ink runs on this fruit: the colour of its lines.
struct InkStyle {
  Color color{0.03f, 0.02f, 0.015f};
  double width = 1.0;  ///< times the style's
};

struct Template {
  std::string name;   ///< as in `pomona list`
  std::string title;  ///< for people: "Bell pepper"
  std::string file;   ///< where it was read from, for messages
  Symmetry symmetry;
  std::vector<std::string> parts;
  std::vector<SurfaceSketch> surfaces;
  std::vector<GrainSketch> grains;
  NoiseStyle noise;
  InkStyle ink;
  double density = 950;  ///< kg per cubic metre
};

/// The surface's `reference` if set. Else, around the axis: the loop's radius at the reference azimuth, or its mean;
/// in folds: least and largest radius of the loop nearest to the reference azimuth, or their means over all loops.
ReferenceRadii reference_radii(const SurfaceSketch& surface);

/// Folds, or 1 for cylindrical symmetry.
int fold_count(const Template& fruit);

}  // namespace pomona
