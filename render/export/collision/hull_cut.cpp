#include "render/export/collision/hull_cut.h"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/signed_volume.h"

namespace pomona {

namespace {

/// A triangle or what a plane leaves of it, four corners at most.
struct KeptCorners {
  std::array<glm::dvec3, 4> corner;
  std::size_t count = 0;
};

KeptCorners kept_before(const std::array<glm::dvec3, 3>& triangle, const std::array<double, 3>& height) {
  KeptCorners kept;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (height[k] >= 0) kept.corner[kept.count++] = triangle[k];
    if ((height[k] < 0) != (height[next] < 0)) {
      const double share = height[k] / (height[k] - height[next]);
      kept.corner[kept.count++] = triangle[k] + share * (triangle[next] - triangle[k]);
    }
  }
  return kept;
}

}  // namespace

double volume_of(const ConvexHull& hull) {
  if (hull.triangle.empty()) return 0;
  const glm::dvec3 middle(hull.position.front());
  return signed_volume(hull.triangle, [&](const glm::uvec3& t) {
    const auto corner = [&](std::uint32_t v) { return glm::dvec3(hull.position[v]) - middle; };
    return std::array{corner(t.x), corner(t.y), corner(t.z)};
  });
}

double volume_before(std::span<const glm::dvec3> corners, std::span<const glm::uvec3> triangles,
                     const CuttingPlane& plane) {
  // Seen from a point of the plane, the cut face adds nothing.
  const glm::dvec3 tip = plane.offset * plane.normal;
  double six = 0;
  for (const glm::uvec3& t : triangles) {
    const std::array<glm::dvec3, 3> c{corners[t.x] - tip, corners[t.y] - tip, corners[t.z] - tip};
    const std::array<double, 3> height{glm::dot(plane.normal, c[0]), glm::dot(plane.normal, c[1]),
                                       glm::dot(plane.normal, c[2])};
    if (height[0] < 0 && height[1] < 0 && height[2] < 0) continue;
    const KeptCorners kept = kept_before(c, height);
    for (std::size_t k = 2; k < kept.count; ++k) six += six_volumes(kept.corner[0], kept.corner[k - 1], kept.corner[k]);
  }
  return six / 6;
}

ConvexHull behind(const ConvexHull& hull, const CuttingPlane& plane, std::size_t most) {
  const auto height = [&](const glm::vec3& p) { return glm::dot(plane.normal, glm::dvec3(p)) - plane.offset; };
  std::vector<glm::vec3> points;
  for (const glm::vec3& p : hull.position)
    if (height(p) <= 0) points.push_back(p);
  for (const glm::uvec3& t : hull.triangle) {
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 a = hull.position[t[k]], b = hull.position[t[(k + 1) % 3]];
      const double from = height(a), to = height(b);
      if (from < 0 && to > 0) points.emplace_back(glm::dvec3(a) + from / (from - to) * glm::dvec3(b - a));
    }
  }
  return convex_hull(points, most);
}

}  // namespace pomona
