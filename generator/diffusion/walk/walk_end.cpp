#include "generator/diffusion/walk/walk_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"

namespace pomona {

namespace {

/// Distances closer than this are equal up to rounding.
constexpr double tie = 1e-12;

/// A triangle near the point, with its nearest place.
struct NearTriangle {
  std::uint32_t triangle = 0;
  std::array<glm::dvec3, 3> corner;
  glm::dvec3 barycentric{0};
  double distance = 0;
  double height = 0;  ///< height of the point above the triangle's plane

  glm::dvec3 at(const glm::dvec3& weight) const {
    return weight.x * corner[0] + weight.y * corner[1] + weight.z * corner[2];
  }
};

NearTriangle candidate_of(const DiffusionSurfaces& surfaces, const TriangleFrames& frames, std::uint32_t triangle,
                          const glm::dvec3& point) {
  NearTriangle found{.triangle = triangle, .corner = corners(surfaces, triangle)};
  for (glm::dvec3& corner : found.corner) corner = frames.normalized(corner);
  const auto& [a, b, c] = found.corner;
  found.barycentric = nearest_weights(point, a, b, c);
  found.distance = glm::length(point - found.at(found.barycentric));
  found.height = glm::dot(point - a, glm::normalize(glm::cross(b - a, c - a)));
  return found;
}

/// Six times the volume of a tetrahedron; positive where d sees abc counter-clockwise.
double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return glm::dot(glm::cross(b - a, c - a), d - a);
}

/// Whether the segment pq passes through a triangle's inside.
bool is_crossed(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& p, const glm::dvec3& q) {
  const auto& [a, b, c] = corner;
  if ((volume(a, b, c, p) > 0) == (volume(a, b, c, q) > 0)) return false;
  const bool ab = volume(p, q, a, b) > 0, bc = volume(p, q, b, c) > 0, ca = volume(p, q, c, a) > 0;
  return ab == bc && bc == ca;
}

/// Whether nothing among `others` lies between the point and a place a little way into the candidate's triangle.
bool is_seen(const NearTriangle& candidate, const std::vector<NearTriangle>& others, const glm::dvec3& point) {
  constexpr double inwards = 0.01;
  const glm::dvec3 place = candidate.at((1 - inwards) * candidate.barycentric + glm::dvec3(inwards / 3));
  return std::none_of(others.begin(), others.end(), [&](const NearTriangle& other) {
    return other.triangle != candidate.triangle && is_crossed(other.corner, point, place);
  });
}

}  // namespace

SurfaceSide side_next_to(const DiffusionSurfaces& surfaces, const EmptyBalls& balls, const glm::dvec3& point) {
  // Keeps the nearest candidates.
  std::vector<NearTriangle> nearest;
  for (const std::uint32_t triangle : balls.nearest_triangles(point)) {
    nearest.push_back(candidate_of(surfaces, balls.frames(), triangle, point));
  }
  const auto by_distance = [](const NearTriangle& a, const NearTriangle& b) { return a.distance < b.distance; };
  const double limit = std::min_element(nearest.begin(), nearest.end(), by_distance)->distance + tie;
  std::erase_if(nearest, [&](const NearTriangle& candidate) { return candidate.distance > limit; });

  // Of several, takes the one that faces the point most directly and is not behind another.
  std::sort(nearest.begin(), nearest.end(), [](const NearTriangle& a, const NearTriangle& b) {
    const double facing_a = std::fabs(a.height), facing_b = std::fabs(b.height);
    return facing_a != facing_b ? facing_a > facing_b : a.triangle < b.triangle;
  });
  auto seen = nearest.begin();
  if (nearest.size() > 2) {
    seen = std::find_if(nearest.begin(), nearest.end(),
                        [&](const NearTriangle& candidate) { return is_seen(candidate, nearest, point); });
    if (seen == nearest.end()) seen = nearest.begin();
  }
  return {seen->triangle, seen->height < 0 ? SideOf::back : SideOf::front, seen->barycentric,
          seen->distance * balls.frames().radius};
}

}  // namespace pomona
