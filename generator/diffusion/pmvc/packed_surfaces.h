// Diffusion surfaces prepared for the sweep over lines: single precision, sixteen triangles at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// Sixteen neighbouring triangles. The last group repeats triangle ids, without area.
struct alignas(64) TriangleGroup {
  static constexpr int size = 16;
  float corner[9][size];        ///< x, y, z of the three corners, normalised
  std::int32_t triangle[size];  ///< index into the surfaces
};

/// Lengths here are normalised: the middle of the surfaces is 0, and a power of two brings them into [-1, 1].
struct PackedSurfaces {
  std::vector<TriangleGroup> groups;

  // Linear colour and 1 per vertex, so that a weighted sum includes its weight.
  std::vector<glm::vec4> front_color;
  std::vector<glm::vec4> back_color;
  std::vector<float> fourth;  ///< a further value per vertex, the same on both sides; empty if there is none
  std::vector<std::array<std::int32_t, 3>> triangle;

  // One entry per triangle: index into used_parts.
  std::vector<std::uint16_t> front_part;
  std::vector<std::uint16_t> back_part;
  std::vector<std::int32_t> used_parts;  ///< ascending; index into part_names

  glm::dvec3 middle{0};  ///< metres
  double scale = 1;      ///< normalised lengths per metre

  glm::vec3 normalized(const glm::vec3& point) const;
};

/// \throws Error (bad_data) if more than 1024 parts are used.
PackedSurfaces pack(const DiffusionSurfaces& surfaces, const SurfaceTree& tree);

}  // namespace pomona
