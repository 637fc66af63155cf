#include "generator/surface/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>

#include <glm/ext/vector_int3_sized.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/connected_vertices.h"
#include "generator/mesh/overlapping_boxes.h"
#include "generator/surface/surface_tiles.h"

namespace pomona {

namespace {

/// A position in whole steps. 29 bits a coordinate let volumes be computed exactly in 128 bits; doubles hold them, and
/// their differences, as they are.
using LatticePoint = glm::dvec3;
__extension__ typedef __int128 Wide;
constexpr double grid_steps = 1 << 29;

/// Rounds positions to whole steps.
class RoundingGrid {
 public:
  explicit RoundingGrid(const DiffusionSurfaces& surfaces) : bounds_(bounds_of(surfaces)) {
    const glm::dvec3 size = bounds_.size();
    longest_ = std::max({size.x, size.y, size.z});
    steps_per_metre_ = longest_ > 0 ? grid_steps / longest_ : 0;
  }

  double step() const { return longest_ / grid_steps; }  ///< metres

  LatticePoint at(const glm::vec3& p) const {
    const glm::dvec3 place = (glm::dvec3(p) - bounds_.low) * steps_per_metre_;
    return {rounded(place.x), rounded(place.y), rounded(place.z)};
  }

 private:
  /// Halves are rounded up.
  static double rounded(double at) {
    if (!(at >= 0)) return 0;
    const double within = std::min(at, grid_steps);
    const auto whole = static_cast<double>(static_cast<std::int64_t>(within));
    return within - whole >= 0.5 ? whole + 1 : whole;
  }

  Box<double> bounds_;
  double longest_ = 0, steps_per_metre_ = 0;
};

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

/// Whether boxes have more in common than faces. Triangles in boxes that only touch cannot cross properly, however
/// their corners are rounded to the grid: rounding keeps the order. Rings of a straight fruit lie at one height, so
/// half of all boxes that meet only touch.
bool boxes_overlap(const Box<float>& a, const Box<float>& b) {
  return (a.low.x < b.high.x) & (b.low.x < a.high.x) & (a.low.y < b.high.y) & (b.low.y < a.high.y) &
         (a.low.z < b.high.z) & (b.low.z < a.high.z);
}

/// The box less its upper faces: such boxes meet where the whole ones overlap.
Box<float> without_upper_faces(Box<float> box) {
  for (int i = 0; i < 3; ++i) box.high[i] = std::nextafter(box.high[i], std::numeric_limits<float>::lowest());
  return box;
}

/// Surfaces, by number; all, if empty.
using ChosenSurfaces = std::vector<std::uint8_t>;

/// Looks for triangles that cross, tile by tile.
class CrossingSearch {
 public:
  explicit CrossingSearch(const DiffusionSurfaces& surfaces)
      : surfaces_(surfaces), lattice_(surfaces), tiles_(surfaces, lattice_.step()), number_(surfaces.triangle_count()) {
    box_.reserve(surfaces.triangle_count());
    for (const glm::uvec3& v : surfaces.triangle)
      box_.push_back(box_around(surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]));
  }

  /// Calls found(crossing) for every pair of triangles of some surfaces that cross, until it returns false.
  template <typename Found>
  void visit(const ChosenSurfaces& chosen, const Found& found) {
    std::vector<std::uint32_t> tile;
    std::vector<Box<float>> boxes;
    around_.assign(tiles_.count(), {});
    for (std::uint32_t i = 0; i < tiles_.count(); ++i) {
      const std::span<const std::uint32_t> triangles = tiles_.triangles(i);
      if (triangles.empty() || !is_among(chosen, triangles.front())) continue;
      for (const std::uint32_t t : triangles) around_[i].add(box_[t]);
      tile.push_back(i), boxes.push_back(without_upper_faces(around_[i]));
    }
    for (const std::uint32_t i : tile)
      if (!visit_pairs(i, i, found)) return;
    visit_overlapping_boxes(boxes,
                            [&](std::uint32_t i, std::uint32_t j) { return visit_pairs(tile[i], tile[j], found); });
  }

 private:
  bool is_among(const ChosenSurfaces& chosen, std::uint32_t triangle) const {
    return chosen.empty() || chosen[static_cast<std::size_t>(surfaces_.surface[triangle])] != 0;
  }

  /// False if found() was.
  template <typename Found>
  bool visit_pairs(std::uint32_t one, std::uint32_t other, const Found& found) {
    if (tiles_.are_clear(one, other)) return true;
    near_.clear();
    for (const std::uint32_t t : tiles_.triangles(other))
      if (boxes_overlap(box_[t], around_[one])) near_.push_back(t);
    for (const std::uint32_t s : tiles_.triangles(one)) {
      if (!boxes_overlap(box_[s], around_[other])) continue;
      for (const std::uint32_t t : near_) {
        if ((one == other && t <= s) || !boxes_overlap(box_[s], box_[t])) continue;
        if (cross(s, t) && !found(crossing(std::min(s, t), std::max(s, t)))) return false;
      }
    }
    return true;
  }

  bool cross(std::uint32_t s, std::uint32_t t) {
    if (share_an_edge(surfaces_.triangle[s], surfaces_.triangle[t])) return false;
    const std::uint32_t one = rounded(s), other = rounded(t);
    return cross_properly(rounded_[one], rounded_[other]);
  }

  /// The number of a triangle on the lattice: few are ever asked for.
  std::uint32_t rounded(std::uint32_t triangle) {
    if (number_[triangle] == 0) {
      const glm::uvec3& v = surfaces_.triangle[triangle];
      const auto at = [&](std::uint32_t vertex) { return lattice_.at(surfaces_.position[vertex]); };
      rounded_.push_back(grid_triangle(at(v.x), at(v.y), at(v.z)));
      number_[triangle] = static_cast<std::uint32_t>(rounded_.size());
    }
    return number_[triangle] - 1;
  }

  /// Connected parts matter only once something crosses.
  CrossingTriangles crossing(std::uint32_t first, std::uint32_t second) {
    if (!pieces_) pieces_ = connected_vertices(surfaces_.vertex_count(), surfaces_.triangle);
    const std::uint32_t a = surfaces_.triangle[first].x, b = surfaces_.triangle[second].x;
    return {first, second, pieces_->root(a) == pieces_->root(b)};
  }

  const DiffusionSurfaces& surfaces_;
  RoundingGrid lattice_;
  SurfaceTiles tiles_;
  std::vector<Box<float>> box_;        // per triangle
  std::vector<Box<float>> around_;     // per tile
  std::vector<std::uint32_t> near_;    // triangles of one tile that could meet the other
  std::vector<std::uint32_t> number_;  // per triangle: one more than its place in rounded_, or 0
  std::vector<GridTriangle> rounded_;
  std::optional<DisjointSets> pieces_;
};

ChosenSurfaces surfaces_of(const DiffusionSurfaces& surfaces, const std::set<CrossingKind>& kinds) {
  ChosenSurfaces chosen(surfaces.surface_names.size(), 0);
  for (const auto& [a, b, same_piece] : kinds) {
    for (const std::int32_t surface : {a, b})
      if (static_cast<std::size_t>(surface) < chosen.size()) chosen[static_cast<std::size_t>(surface)] = 1;
  }
  return chosen;
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
  CrossingSearch(surfaces).visit({}, [&](const CrossingTriangles& crossing) {
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
  CrossingSearch(surfaces).visit(surfaces_of(surfaces, wanted), [&](const CrossingTriangles& crossing) {
    const CrossingKind kind = kind_of(surfaces, crossing);
    if (wanted.contains(kind)) found.insert(kind);
    return found.size() < wanted.size();
  });
  return found;
}

}  // namespace pomona
