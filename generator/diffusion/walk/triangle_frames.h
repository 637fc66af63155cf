// Triangles prepared for distances: each in a frame of its own, eight at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/surface_tree.h"

namespace pomona {

/// Eight neighbouring triangles. In its frame a triangle is (0, 0), (length, 0), (apex_u, apex_v), its longest edge
/// along u and its front towards w. The last group of all repeats its last triangle.
struct alignas(32) FrameGroup {
  static constexpr int size = 8;
  float origin[3][size];  ///< normalised
  float u[3][size];       ///< unit vectors
  float v[3][size];
  float w[3][size];
  float length[size];
  float apex_u[size];
  float apex_v[size];
  float per_left[size];          ///< 1 / squared length of the edge from the origin to the apex
  float per_right[size];         ///< 1 / squared length of the edge from the far end to the apex
  std::uint32_t triangle[size];  ///< index into the surfaces
};

/// Lengths here are normalised: the middle of the surfaces' box is 0, and no vertex is farther from it than 1.
struct TriangleFrames {
  std::vector<FrameGroup> groups;
  glm::dvec3 middle{0};  ///< metres
  double radius = 1;     ///< metres; normalised 1

  glm::dvec3 normalized(const glm::dvec3& point) const { return (point - middle) / radius; }
};

/// Takes the triangles in the tree's order, along which neighbours are near each other.
TriangleFrames make_triangle_frames(const DiffusionSurfaces& surfaces, const SurfaceTree& tree);

}  // namespace pomona
