#include "generator/surface/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/overlapping_boxes.h"

namespace pomona {

namespace {

/// A position in whole steps. 29 bits a coordinate let volumes be computed exactly in 128 bits; doubles hold them, and
/// their differences, as they are.
using LatticePoint = glm::dvec3;
__extension__ typedef __int128 Wide;
constexpr double grid_steps = 1 << 29;

std::vector<LatticePoint> on_grid(const DiffusionSurfaces& surfaces) {
  const Box<double> bounds = bounds_of(surfaces);
  const glm::dvec3 size = bounds.size();
  const double longest = std::max({size.x, size.y, size.z});
  const double steps_per_metre = longest > 0 ? grid_steps / longest : 0;
  // Vertices that no triangle uses may lie anywhere. Halves are rounded up.
  const auto step = [](double at) {
    if (!(at >= 0)) return 0.0;
    const double within = std::min(at, grid_steps);
    const auto whole = static_cast<double>(static_cast<std::int64_t>(within));
    return within - whole >= 0.5 ? whole + 1 : whole;
  };
  std::vector<LatticePoint> points;
  points.reserve(surfaces.position.size());
  for (const glm::vec3& p : surfaces.position) {
    const glm::dvec3 at = (glm::dvec3(p) - bounds.low) * steps_per_metre;
    points.emplace_back(step(at.x), step(at.y), step(at.z));
  }
  return points;
}

/// The exact side, 1, 0 or -1, of the plane through a with these two edges.
int exact_side(const LatticePoint& u, const LatticePoint& v, const LatticePoint& w) {
  const glm::i64vec3 a(u), b(v), c(w);
  const Wide volume = static_cast<Wide>(a.y * b.z - a.z * b.y) * c.x + static_cast<Wide>(a.z * b.x - a.x * b.z) * c.y +
                      static_cast<Wide>(a.x * b.y - a.y * b.x) * c.z;
  return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
}

/// The sign of a volume that doubles have estimated, with rounding below 2^42; 2 if it is not certain.
int estimated_side(double volume) {
  if (std::abs(volume) > 0x1p44) return volume > 0 ? 1 : -1;
  return 2;
}

/// A triangle, and its plane.
struct GridTriangle {
  std::array<LatticePoint, 3> corner;
  glm::dvec3 normal{0};  ///< rounded

  /// The side of the plane on which p lies.
  int side_of(const LatticePoint& p) const {
    const int estimate = estimated_side(glm::dot(normal, p - corner[0]));
    if (estimate != 2) return estimate;
    // Most triangles that are near each other share a corner.
    if (p == corner[0] || p == corner[1] || p == corner[2]) return 0;
    return exact_side(corner[1] - corner[0], corner[2] - corner[0], p - corner[0]);
  }
};

GridTriangle grid_triangle(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return {{a, b, c}, glm::cross(b - a, c - a)};
}

using Sides = std::array<int, 3>;

Sides sides_of(const GridTriangle& triangle, const GridTriangle& t) {
  return {triangle.side_of(t.corner[0]), triangle.side_of(t.corner[1]), triangle.side_of(t.corner[2])};
}

bool on_both(const Sides& sides) {
  return std::min({sides[0], sides[1], sides[2]}) < 0 && std::max({sides[0], sides[1], sides[2]}) > 0;
}

/// True if the line goes through the inside of the triangle.
bool line_pierces(const LatticePoint& p, const LatticePoint& q, const GridTriangle& t) {
  const auto side_of = [&](std::size_t i, std::size_t j) {
    return grid_triangle(p, q, t.corner[i]).side_of(t.corner[j]);
  };
  const int first = side_of(0, 1);
  return first != 0 && side_of(1, 2) == first && side_of(2, 0) == first;
}

/// True if an edge of t, whose corners lie on these sides of s, goes through s.
bool edge_pierces(const GridTriangle& t, const Sides& sides, const GridTriangle& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides[i] * sides[j] < 0 && line_pierces(t.corner[i], t.corner[j], s)) return true;
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
  for (int i = 0; i < 3; ++i) common += (a[i] == b.x ? 1 : 0) + (a[i] == b.y ? 1 : 0) + (a[i] == b.z ? 1 : 0);
  return common > 1;
}

/// Connected triangles.
DisjointSets pieces_of(const DiffusionSurfaces& surfaces) {
  DisjointSets pieces(surfaces.vertex_count());
  for (const glm::uvec3& v : surfaces.triangle) {
    pieces.join(v.x, v.y);
    pieces.join(v.x, v.z);
  }
  return pieces;
}

/// The box around a triangle, less its upper faces, so that boxes which only touch do not meet. Triangles in them
/// cannot cross properly, however their corners are rounded to the grid: rounding keeps the order. Rings of a straight
/// fruit lie at one height, so half of all boxes that meet only touch. Empty where a number is not finite.
Box<float> open_box_around(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  Box<float> box = box_around(a, b, c);
  const auto is_finite = [](const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return {};
  for (int i = 0; i < 3; ++i) box.high[i] = std::nextafter(box.high[i], std::numeric_limits<float>::lowest());
  return box;
}

/// Calls found(crossing) for every pair among some triangles that cross, until it returns false.
template <typename Found>
void visit_crossings(const DiffusionSurfaces& surfaces, const std::vector<std::uint32_t>& triangles,
                     const Found& found) {
  // Finds triangles that could meet.
  const std::vector<LatticePoint> points = on_grid(surfaces);
  std::vector<GridTriangle> corners;
  std::vector<Box<float>> boxes;
  corners.reserve(triangles.size());
  boxes.reserve(triangles.size());
  for (const std::uint32_t t : triangles) {
    const glm::uvec3& v = surfaces.triangle[t];
    corners.push_back(grid_triangle(points[v.x], points[v.y], points[v.z]));
    boxes.push_back(open_box_around(surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]));
  }

  // Tests these. Connected parts matter only once something crosses.
  std::optional<DisjointSets> pieces;
  visit_overlapping_boxes(boxes, [&](std::uint32_t i, std::uint32_t j) {
    const glm::uvec3 &a = surfaces.triangle[triangles[i]], &b = surfaces.triangle[triangles[j]];
    if (share_an_edge(a, b) || !cross_properly(corners[i], corners[j])) return true;
    if (!pieces) pieces = pieces_of(surfaces);
    return found(CrossingTriangles{triangles[i], triangles[j], pieces->root(a.x) == pieces->root(b.x)});
  });
}

std::vector<std::uint32_t> all_triangles(const DiffusionSurfaces& surfaces) {
  std::vector<std::uint32_t> all(surfaces.triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// The triangles of the surfaces of these kinds.
std::vector<std::uint32_t> triangles_of(const DiffusionSurfaces& surfaces, const std::set<CrossingKind>& kinds) {
  std::vector<std::uint8_t> counts(surfaces.surface_names.size(), 0);
  for (const auto& [a, b, same_piece] : kinds) {
    for (const std::int32_t surface : {a, b})
      if (static_cast<std::size_t>(surface) < counts.size()) counts[static_cast<std::size_t>(surface)] = 1;
  }
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t)
    if (counts[static_cast<std::size_t>(surfaces.surface[t])] != 0) triangles.push_back(t);
  return triangles;
}

}  // namespace

CrossingKind kind_of(const DiffusionSurfaces& surfaces, const CrossingTriangles& crossing) {
  const std::int32_t a = surfaces.surface[crossing.first], b = surfaces.surface[crossing.second];
  return {std::min(a, b), std::max(a, b), crossing.same_piece};
}

std::set<CrossingKind> kinds_of(const DiffusionSurfaces& surfaces, const std::vector<CrossingTriangles>& crossings) {
  std::set<CrossingKind> kinds;
  for (const CrossingTriangles& crossing : crossings) kinds.insert(kind_of(surfaces, crossing));
  return kinds;
}

std::vector<CrossingTriangles> crossing_triangles(const DiffusionSurfaces& surfaces) {
  std::vector<CrossingTriangles> found;
  visit_crossings(surfaces, all_triangles(surfaces), [&](const CrossingTriangles& crossing) {
    found.push_back(crossing);
    return true;
  });
  std::sort(found.begin(), found.end(), [](const CrossingTriangles& l, const CrossingTriangles& r) {
    return std::tie(l.first, l.second) < std::tie(r.first, r.second);
  });
  return found;
}

std::set<CrossingKind> crossing_kinds(const DiffusionSurfaces& surfaces) {
  return kinds_of(surfaces, crossing_triangles(surfaces));
}

std::set<CrossingKind> crossing_kinds_of(const DiffusionSurfaces& surfaces, const std::set<CrossingKind>& wanted) {
  std::set<CrossingKind> found;
  if (wanted.empty()) return found;
  visit_crossings(surfaces, triangles_of(surfaces, wanted), [&](const CrossingTriangles& crossing) {
    const CrossingKind kind = kind_of(surfaces, crossing);
    if (wanted.contains(kind)) found.insert(kind);
    return found.size() < wanted.size();
  });
  return found;
}

}  // namespace pomona
