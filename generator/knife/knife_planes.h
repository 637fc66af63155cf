// A knife placed at a fruit: its planes, and the cells into which they divide space.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The sides of a knife's planes on which a point lies, as far as the cell depends on them.
struct KnifeSides {
  bool first = false;  ///< the point is on the positive side of the first plane
  /// For each direction, the number of planes on whose positive side the point lies. For reversed planes of a pencil,
  /// it is the negative side.
  std::array<int, 3> positive{};
};

/// The planes of one knife at a fruit, and the rule that gives the cell of a point from its sides. The planes of wedges
/// form a pencil, sorted by their angle about the axis; the cut is then only the half of a plane where two different
/// cells meet (the whole plane if N is even). A closed knife has no planes and two cells; before its surface is placed
/// (closed_knives.h), everything lies in the first cell.
struct KnifePlanes {
  std::vector<CuttingPlane> planes;
  std::vector<std::uint8_t> reversed;   ///< 1 where the normal of a pencil's plane points against the rotation
  std::vector<std::uint8_t> direction;  ///< 0..2; parallel planes have the same
  std::array<int, 3> across{1, 1, 1};   ///< number of cells along each direction; not used for a pencil
  int wedges = 0;    ///< number of wedges of a pencil (all planes contain the axis x = z = 0); else 0
  std::string text;  ///< the knife as written, for messages

  /// The points of a stroke; for crinkled slices, those of each stroke, from bottom to top. The planes are then those
  /// of their edges, in this order, and the sides are those of the strokes.
  std::vector<std::vector<glm::dvec2>> strokes;

  /// `before`, together with the side of planes[plane] on which the point lies.
  KnifeSides seen(KnifeSides before, std::size_t plane, bool positive_side) const;

  /// The cell of a point, in [0, cell_count()), from its sides of all planes. This knife separates two points exactly
  /// if their cells differ.
  int cell(const KnifeSides& sides) const;
  int cell_count() const;
};

/// Places the knife at a fruit with these bounds.
/// \throws Error (usage) for more than 1024 slices in one direction, slices thinner than 1/10 000 of the fruit, and
/// strokes that cross themselves where their ends go on straight.
KnifePlanes planes_of(const Knife& knife, const Box<double>& bounds);

}  // namespace pomona
