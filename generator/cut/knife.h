// Knives: cutting surfaces by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The points p with dot(normal, p) = offset; the positive side is where the normal points.
struct CuttingPlane {
  glm::dvec3 normal{0, 1, 0};  ///< unit length up to rounding
  double offset = 0;           ///< metres
};

/// One knife as the user wrote it. What it does may depend on the fruit's bounding box.
struct Knife {
  enum class Kind { plane, half, across, wedges, slices };
  Kind kind = Kind::half;
  CuttingPlane plane;    ///< Kind::plane
  int count = 0;         ///< wedges, slices by count
  double thickness = 0;  ///< slices by thickness, metres; 0 = by count
  std::string text;      ///< as written, for messages and metadata
};

/// Reads "half", "across", "plane:NX,NY,NZ,D", "wedges:N", "slices:4mm", "slices:8" (docs/commands.md).
/// \throws Error (usage) that says what a knife looks like.
Knife parse_knife(std::string_view text);

/// A knife laid at a fruit: planes, and the rule that makes cells of the sides they see. All planes of wedges
/// share the axis; the cut is then the half-plane of each on which two different cells meet.
struct PlacedKnife {
  std::vector<CuttingPlane> planes;
  bool pencil = false;  ///< all planes contain the axis x = z = 0
  Knife knife;

  /// The cell of a point from its sides of the planes (1 = positive or on it), the same for all knives: two
  /// points are parted by this knife exactly if their cells differ.
  int cell(const std::vector<std::uint8_t>& sides) const;
};

/// \throws Error (usage) for more than 4096 slices, or slices thinner than 1/10 000 of the fruit.
PlacedKnife placed(const Knife& knife, const Bounds& bounds);

}  // namespace pomona
