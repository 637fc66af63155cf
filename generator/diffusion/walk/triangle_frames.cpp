#include "generator/diffusion/walk/triangle_frames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// The reciprocal, bounded so that it fits a float even for nearly flat triangles.
float narrow(double value) { return static_cast<float>(std::min(value, 1e30)); }

void store(float (&to)[3][FrameGroup::size], int lane, const glm::dvec3& vector) {
  for (int k = 0; k < 3; ++k) to[k][lane] = static_cast<float>(vector[k]);
}

void put(FrameGroup& group, int lane, std::array<glm::dvec3, 3> corner, std::uint32_t triangle) {
  // Begins with the longest edge, and keeps the orientation.
  const auto edge = [&](int k) { return corner[(k + 1) % 3] - corner[k]; };
  int longest = 0;
  for (int k = 1; k < 3; ++k) {
    if (glm::dot(edge(k), edge(k)) > glm::dot(edge(longest), edge(longest))) longest = k;
  }
  std::rotate(corner.begin(), corner.begin() + longest, corner.end());

  const glm::dvec3 base = corner[1] - corner[0], left = corner[2] - corner[0], right = corner[2] - corner[1];
  const glm::dvec3 u = glm::normalize(base), w = glm::normalize(glm::cross(base, left)), v = glm::cross(w, u);
  store(group.origin, lane, corner[0]);
  store(group.u, lane, u);
  store(group.v, lane, v);
  store(group.w, lane, w);
  group.length[lane] = static_cast<float>(glm::length(base));
  group.apex_u[lane] = static_cast<float>(glm::dot(left, u));
  group.apex_v[lane] = static_cast<float>(glm::dot(left, v));
  group.per_left[lane] = narrow(1 / glm::dot(left, left));
  group.per_right[lane] = narrow(1 / glm::dot(right, right));
  group.triangle[lane] = triangle;
}

}  // namespace

TriangleFrames make_triangle_frames(const DiffusionSurfaces& surfaces, const SurfaceTree& tree) {
  // Finds the ball around all.
  TriangleFrames frames;
  frames.middle = tree.levels.back().front().center();
  double squared = 0;
  for (const std::uint32_t triangle : tree.order) {
    for (const glm::dvec3& corner : corners(surfaces, triangle)) {
      squared = std::max(squared, glm::dot(corner - frames.middle, corner - frames.middle));
    }
  }
  frames.radius = std::sqrt(squared);

  // Fills the groups; the rest of the last group repeats its last triangle.
  const std::size_t count = tree.order.size(), size = FrameGroup::size;
  frames.groups.resize((count + size - 1) / size);
  for (std::size_t i = 0; i < frames.groups.size() * size; ++i) {
    const std::uint32_t triangle = tree.order[std::min(i, count - 1)];
    std::array<glm::dvec3, 3> corner = corners(surfaces, triangle);
    for (glm::dvec3& c : corner) c = frames.normalized(c);
    put(frames.groups[i / size], static_cast<int>(i % size), corner, triangle);
  }
  return frames;
}

}  // namespace pomona
