// Cells packed in space: what vesicles, grains and nets are made of.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// The two feature points nearest to a place, of one in each unit cell of a lattice [Worley 1996].
struct CellPlace {
  double nearest = 0;      ///< distance to the nearest feature point
  double second = 0;       ///< to the second nearest; where both are equal two cells meet
  std::uint32_t hash = 0;  ///< of the nearest one's own
};

/// Feature points lie anywhere in the middle nine tenths of their unit cells. Only + - * floor and square roots: the
/// same bits everywhere.
CellPlace cell_place(const glm::dvec3& point, std::uint32_t seed);

}  // namespace pomona
