// A knife laid at a fruit: its planes, and the cells they make.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// What a knife's cells depend on: the sides of its planes that a point has been seen to lie on.
struct KnifeSides {
  bool first = false;  ///< positive side of the first plane
  /// On the positive side of how many planes the point lies, direction by direction. A pencil's reversed planes are
  /// counted where it lies on their negative side.
  std::array<int, 3> positive{};
};

/// The planes of one knife at a fruit, and the rule that makes cells of the sides they see. The planes of wedges form
/// a pencil, in the order of their angle about the axis; the cut is then only the half of a plane on which two
/// different cells meet (all of it where N is even). A closed knife has no planes and two cells: until its surface is
/// laid on (closed_knives.h) everything lies in the first.
struct KnifePlanes {
  std::vector<CuttingPlane> planes;
  std::vector<std::uint8_t> reversed;   ///< 1 where a pencil's plane looks against the sense of rotation
  std::vector<std::uint8_t> direction;  ///< 0..2: parallel planes have the same
  std::array<int, 3> across{1, 1, 1};   ///< cells along each direction; of no meaning for a pencil
  int wedges = 0;                       ///< of a pencil, whose planes all contain the axis x = z = 0; else 0
  std::string text;                     ///< the knife as written, for messages

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

/// Lays the knife at a fruit with these bounds.
/// \throws Error (usage) for more than 1024 slices in one direction, slices thinner than 1/10 000 of the fruit, and
/// strokes that cross themselves where their ends go on straight.
KnifePlanes planes_of(const Knife& knife, const Box<double>& bounds);

}  // namespace pomona
