// Gradient noise: smooth noise in space, on a lattice, for styles, strokes and patches of ripeness.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// Gradient noise [Perlin 2002] with hashed lattice gradients; in [-1, 1], zero at lattice points, twice
/// continuously differentiable. Only + - * and floor: the same bits everywhere.
double gradient_noise(const glm::dvec3& point, std::uint32_t seed);

/// The same, repeating along z every `period` (a power of two).
double gradient_noise_around(const glm::dvec3& point, std::uint32_t seed, std::int32_t period);

/// A lattice point's 32 random bits: an odd multiplier for each axis [Teschner et al. 2003], then a mix of the bits.
std::uint32_t lattice_hash(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed);

/// A lattice index. Positions that do not fit into 32 bits (after hostile frequencies) all get the last cell.
std::int32_t lattice_cell(double floored);

}  // namespace pomona
