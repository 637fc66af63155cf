// Knives: cutting surfaces by name.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/curve.h"
#include "generator/mesh/closed_surface.h"

namespace pomona {

/// The points p with dot(normal, p) = offset; the positive side is where the normal points.
struct CuttingPlane {
  glm::dvec3 normal{0, 1, 0};  ///< unit length up to rounding
  double offset = 0;           ///< metres
};

/// What the user says of a knife that cuts by a closed surface. Lengths in metres.
struct SolidShape {
  double size = 0;                 ///< ball, core: diameter; bite: width; peel: thickness
  double depth = 0;                ///< core: from the top of the fruit; 0 = right through
  double spiral = 0;               ///< peel: width of the strip; 0 = all in one
  std::optional<glm::dvec3> at;    ///< where its middle goes, of a drawn profile its origin
  std::optional<glm::dvec3> axis;  ///< of core and revolve, unit length
  Curve profile;                   ///< revolve: distance from the axis, height
};

/// One knife as the user wrote it. What it does may depend on the fruit's bounding box.
struct Knife {
  enum class Kind {
    plane,
    half,
    across,
    wedges,
    slices,
    dice,
    sticks,
    stroke,
    crinkle,
    // By a closed surface (solid_knives.h):
    ball,
    core,
    bite,
    revolve,
    peel,
    surface
  };
  Kind kind = Kind::half;
  CuttingPlane plane;              ///< Kind::plane
  int count = 0;                   ///< wedges; slices, dice and sticks by count
  double thickness = 0;            ///< slices, dice, sticks and crinkled slices by thickness, metres; 0 = by count
  std::vector<glm::dvec2> stroke;  ///< metres, seen along -Z
  SolidShape solid;                ///< of those that cut by a closed surface
  std::shared_ptr<const ClosedSurface> surface;  ///< Kind::surface
  std::string text;                              ///< as written, for messages and metadata

  bool is_solid() const { return kind >= Kind::ball; }
};

/// Of slices, dice and sticks, in one direction.
constexpr int most_slices = 1024;

/// \throws Error (usage), always: the knife that is written `text` cannot be, `why`, and what would do.
[[noreturn]] void refuse_knife(std::string_view text, const std::string& why, const std::string& hint);

}  // namespace pomona
