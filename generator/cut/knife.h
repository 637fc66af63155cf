// Knives: cutting surfaces by name.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"
#include "generator/cut/knife_solid.h"
#include "generator/surface/diffusion_surfaces.h"

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
  std::shared_ptr<const KnifeSolid> surface;  ///< Kind::surface
  std::string text;                           ///< as written, for messages and metadata

  bool is_solid() const { return kind >= Kind::ball; }
};

/// Reads "half", "across", "plane:NX,NY,NZ,D", "wedges:N", "slices:4mm", "slices:8", "dice:12mm", "sticks:6mm",
/// "crinkle:6mm", "stroke:FILE.svg#id,scale=2mm", "ball:24mm", "core:18mm", "bite:40mm", "revolve:FILE.svg#id",
/// "peel:2mm", and their options (docs/commands.md). Files are looked for from `folder`.
/// \throws Error (usage) that says what a knife looks like; of strokes and profiles also those of read_stroke.h.
Knife parse_knife(std::string_view text, const std::filesystem::path& folder = {});

/// What a knife's cells depend on: the sides of its planes that a point has been seen to lie on.
struct KnifeSides {
  bool first = false;  ///< positive side of the first plane
  /// Of how many planes, direction by direction; a pencil's taken in turn with one sense of rotation.
  std::array<int, 3> positive{};
};

/// A knife laid at a fruit: planes, and the rule that makes cells of the sides they see. The planes of wedges form
/// a pencil, in the order of their angle about the axis; the cut is then only the half of a plane on which two
/// different cells meet (all of it where N is even).
struct PlacedKnife {
  std::vector<CuttingPlane> planes;
  std::vector<std::uint8_t> reversed;   ///< 1 where a pencil's plane looks against the sense of rotation
  std::vector<std::uint8_t> direction;  ///< 0..2: parallel planes have the same
  std::array<int, 3> across{1, 1, 1};   ///< cells along each direction; of no meaning for a pencil
  bool pencil = false;                  ///< all planes contain the axis x = z = 0
  Knife knife;

  /// Of a stroke: its points; of crinkled slices, those of one stroke after another, from below upwards. The planes are
  /// then those of their edges, in this order, and what is "seen" is on which side of each stroke a point lies.
  std::vector<std::vector<glm::dvec2>> strokes;

  /// `before`, and that the point lies on that side of planes[plane].
  KnifeSides seen(KnifeSides before, std::size_t plane, bool positive_side) const;

  /// The cell of a point of which all planes' sides have been seen, in [0, cell_count()). Two points are parted by
  /// this knife exactly if their cells differ.
  int cell(const KnifeSides& sides) const;
  int cell_count() const;
};

/// \throws Error (usage) for more than 1024 slices in one direction, slices thinner than 1/10 000 of the fruit, and
/// strokes that cross themselves where their ends go on straight.
PlacedKnife placed(const Knife& knife, const Bounds& bounds);

}  // namespace pomona
