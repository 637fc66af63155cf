// Smooth noise in space, tied to a lattice: what styles, strokes and patches of ripeness are made of.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// Gradient noise [Perlin 2002] with hashed lattice gradients; in [-1, 1], zero at lattice points, twice
/// continuously differentiable. Only + - * and floor: the same bits everywhere.
double gradient_noise(const glm::dvec3& point, std::uint32_t seed);

/// The same, repeating along z every `period` (a power of two).
double gradient_noise_around(const glm::dvec3& point, std::uint32_t seed, std::int32_t period);

/// A lattice point's 32 random bits: odd multipliers part the axes [Teschner et al. 2003], a mix does the rest.
std::uint32_t lattice_hash(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed);

/// A lattice index; places beyond what 32 bits hold (hostile frequencies) all share the last cell.
std::int32_t lattice_cell(double floored);

}  // namespace pomona
