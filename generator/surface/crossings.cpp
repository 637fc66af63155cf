#include "generator/surface/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/meeting_boxes.h"

namespace pomona {

namespace {

/// A position in whole steps. 29 bits a coordinate let volumes be computed exactly in 128 bits.
using GridPoint = glm::i64vec3;
using GridTriangle = std::array<GridPoint, 3>;
__extension__ typedef __int128 Wide;
constexpr double grid_steps = 1 << 29;

std::vector<GridPoint> on_grid(const DiffusionSurfaces& surfaces) {
  const Box<double> bounds = bounds_of(surfaces);
  const glm::dvec3 size = bounds.size();
  const double longest = std::max({size.x, size.y, size.z});
  const double steps_per_metre = longest > 0 ? grid_steps / longest : 0;
  // Vertices that no triangle uses may lie anywhere.
  const auto step = [](double at) { return at >= 0 ? std::llround(std::min(at, grid_steps)) : 0; };
  std::vector<GridPoint> points;
  points.reserve(surfaces.position.size());
  for (const glm::vec3& p : surfaces.position) {
    const glm::dvec3 at = (glm::dvec3(p) - bounds.low) * steps_per_metre;
    points.emplace_back(step(at.x), step(at.y), step(at.z));
  }
  return points;
}

/// A triangle's plane, and on which side of it points lie.
class Plane {
 public:
  Plane(const GridPoint& a, const GridPoint& b, const GridPoint& c)
      : a_(a), b_(b), c_(c), u_(b - a), v_(c - a), normal_(glm::cross(glm::dvec3(u_), glm::dvec3(v_))) {}

  /// 1, 0 or -1.
  int side_of(const GridPoint& p) const {
    // In doubles first: differences are exact, and all rounding after them stays below 2^42.
    const GridPoint w = p - a_;
    const double estimate = glm::dot(normal_, glm::dvec3(w));
    if (std::abs(estimate) > 0x1p44) return estimate > 0 ? 1 : -1;

    // Most triangles that are near each other share a corner.
    if (p == a_ || p == b_ || p == c_) return 0;
    const Wide volume = static_cast<Wide>(u_.y * v_.z - u_.z * v_.y) * w.x +
                        static_cast<Wide>(u_.z * v_.x - u_.x * v_.z) * w.y +
                        static_cast<Wide>(u_.x * v_.y - u_.y * v_.x) * w.z;
    return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
  }

 private:
  const GridPoint &a_, &b_, &c_;
  GridPoint u_, v_;
  glm::dvec3 normal_;
};

int side_of(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& p) {
  return Plane(a, b, c).side_of(p);
}

using Sides = std::array<int, 3>;

Sides sides_of(const GridTriangle& triangle, const GridTriangle& t) {
  const Plane plane(triangle[0], triangle[1], triangle[2]);
  return {plane.side_of(t[0]), plane.side_of(t[1]), plane.side_of(t[2])};
}

bool on_both(const Sides& sides) {
  return std::min({sides[0], sides[1], sides[2]}) < 0 && std::max({sides[0], sides[1], sides[2]}) > 0;
}

/// True if the line goes through the inside of the triangle.
bool line_pierces(const GridPoint& p, const GridPoint& q, const GridTriangle& t) {
  const int first = side_of(p, q, t[0], t[1]);
  return first != 0 && side_of(p, q, t[1], t[2]) == first && side_of(p, q, t[2], t[0]) == first;
}

/// True if an edge of t, whose corners lie on these sides of s, goes through s.
bool edge_pierces(const GridTriangle& t, const Sides& sides, const GridTriangle& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides[i] * sides[j] < 0 && line_pierces(t[i], t[j], s)) return true;
  }
  return false;
}

bool cross_properly(const GridTriangle& s, const GridTriangle& t) {
  const Sides sides_t = sides_of(s, t);
  if (!on_both(sides_t)) return false;
  const Sides sides_s = sides_of(t, s);
  return on_both(sides_s) && (edge_pierces(t, sides_t, s) || edge_pierces(s, sides_s, t));
}

bool share_an_edge(const glm::uvec3& a, const glm::uvec3& b) {
  int common = 0;
  for (int i = 0; i < 3; ++i) common += a[i] == b.x || a[i] == b.y || a[i] == b.z;
  return common > 1;
}

}  // namespace

std::vector<CrossingTriangles> crossing_triangles(const DiffusionSurfaces& surfaces) {
  // Find where triangles could meet, and what is connected.
  const std::vector<GridPoint> points = on_grid(surfaces);
  DisjointSets pieces(surfaces.vertex_count());
  std::vector<Box<float>> boxes;
  std::vector<GridTriangle> corners;
  boxes.reserve(surfaces.triangle_count());
  corners.reserve(surfaces.triangle_count());
  for (const glm::uvec3& v : surfaces.triangle) {
    pieces.join(v.x, v.y);
    pieces.join(v.x, v.z);
    Box<float> box;
    for (int i = 0; i < 3; ++i) box.add(glm::vec3(points[v[i]]));
    boxes.push_back(box);
    corners.push_back({points[v.x], points[v.y], points[v.z]});
  }

  // Look closely there.
  std::vector<CrossingTriangles> found;
  for (const auto& [s, t] : meeting_boxes(boxes)) {
    const glm::uvec3 &a = surfaces.triangle[s], &b = surfaces.triangle[t];
    if (share_an_edge(a, b) || !cross_properly(corners[s], corners[t])) continue;
    found.push_back({s, t, pieces.root(a.x) == pieces.root(b.x)});
  }
  std::sort(found.begin(), found.end(), [](const CrossingTriangles& l, const CrossingTriangles& r) {
    return std::tie(l.first, l.second) < std::tie(r.first, r.second);
  });
  return found;
}

CrossingKind kind_of(const DiffusionSurfaces& surfaces, const CrossingTriangles& crossing) {
  const std::int32_t a = surfaces.surface[crossing.first], b = surfaces.surface[crossing.second];
  return {std::min(a, b), std::max(a, b), crossing.same_piece};
}

std::set<CrossingKind> kinds_of(const DiffusionSurfaces& surfaces, const std::vector<CrossingTriangles>& crossings) {
  std::set<CrossingKind> kinds;
  for (const CrossingTriangles& crossing : crossings) kinds.insert(kind_of(surfaces, crossing));
  return kinds;
}

}  // namespace pomona
