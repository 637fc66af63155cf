// Cellular noise: cells packed in space, for vesicles, grains and nets.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// The two feature points nearest to a place, of one in each unit cell of a lattice [Worley 1996].
struct CellPlace {
  double nearest = 0;      ///< distance to the nearest feature point
  double second = 0;       ///< distance to the second nearest; where both are equal, two cells meet
  std::uint32_t hash = 0;  ///< hash of the nearest feature point
};

/// Each feature point lies at random in the middle nine tenths of its unit cell. Uses only + - * floor and square
/// roots, so the bits are the same on every machine.
CellPlace cell_place(const glm::dvec3& point, std::uint32_t seed);

}  // namespace pomona
