#include "generator/knife/skin_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/millimetres.h"
#include "generator/base/parallel.h"
#include "generator/base/reproducible.h"
#include "generator/knife/peel_depth.h"
#include "generator/knife/spiral.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/marching_tetrahedra.h"
#include "generator/surface/crossings.h"

namespace pomona {

namespace {

constexpr double cells_on_skin = 3000;   // some 40 000 triangles
constexpr double cells_in_strip = 6;     // so that a tetrahedron sees one turn of the ridge at most
constexpr double ridge_share = 1 / 30.;  // width of a ridge as a share of a strip's width
constexpr double ridge_height = 1;       // height of a ridge above the skin, in cells
constexpr double ridge_distance = 4;     // distance of a ridge from kept bodies, in cells: a nearer ridge would cut
                                         // crumbs off the peel
constexpr double max_vertices = 6e6;

double area_of(const TriangleTree& skin) {
  double area = 0;
  for (const TriangleTree::Corners& t : skin.triangles()) {
    area += 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
  }
  return area;
}

/// The edge of the grid's cubes, metres; it follows from the size of the skin and the width of a strip.
double cell_of(const DiffusionSurfaces& surfaces, const PeelOptions& options) {
  const double cell = std::sqrt(area_of(SkinDepth(surfaces).skin()) / cells_on_skin);
  return options.strip > 0 ? std::min(cell, options.strip / cells_in_strip) : cell;
}

/// Space around a fruit as tetrahedra (a body-centred cubic lattice), with values at their vertices that decide what
/// the peeler leaves. Marching tetrahedra find the surface (LevelSurface). Vertices are the corners of cubes and their
/// middles. Each edge of a face between two cubes makes a tetrahedron with both their middles, whose edges differ by 15
/// % in length only.
class PeelGrid {
 public:
  /// `shift` moves the whole grid, in cells.
  PeelGrid(const DiffusionSurfaces& surfaces, const PeelOptions& options, double shift)
      : options_(options),
        cell_(cell_of(surfaces, options)),
        depth_(surfaces, options.thickness, cell_),
        outline_(depth_.skin()) {
    // Two cells of air around everything, because the ridge stands out of the skin.
    double count = 2;
    for (int i = 0; i < 3; ++i) {
      const double size = depth_.box().high[i] - depth_.box().low[i];
      const double cubes = std::ceil(size / cell_) + 4;
      count *= cubes + 1;
      if (!(count <= max_vertices)) fail_too_fine();
      cubes_[i] = static_cast<int>(cubes);
      low_[i] = depth_.box().low[i] - 0.5 * (cubes * cell_ - size) + shift * cell_;
    }
    measure();
    if (options_.strip > 0) end_ridge_where_it_is_steep();
  }

  /// The surface of the peeled fruit.
  ClosedSurface surface() const {
    LevelSurface surface({0, 0, 1});  // turns start anew after each, depth and ridge do not
    for (std::size_t i = 0; i < place_.size(); ++i) surface.add_vertex(place_[i], values_[i]);
    for_each_tetrahedron([&](const LevelSurface::Tetrahedron& t) { add(surface, t); });

    // Beside a ridge, vertices may be too near to each other to be moved.
    return options_.strip > 0 ? surface.solid() : moved_onto_offset(surface.solid());
  }

  /// Removes the ridge within two cells of these points. False if there was none.
  bool end_ridge_near(const std::vector<glm::dvec3>& points) {
    bool had_ridge = false;
    for (std::size_t i = 0; i < place_.size(); ++i) {
      if (values_[i][ridge] < 0) continue;
      const auto is_near = [&](const glm::dvec3& p) { return glm::distance(p, place_[i]) < 2 * cell_; };
      if (!std::any_of(points.begin(), points.end(), is_near)) continue;
      values_[i][ridge] = -cell_;
      had_ridge = true;
    }
    return had_ridge;
  }

 private:
  /// The values at each vertex: indices of LevelSurface's functions.
  enum : std::size_t {
    depth,  // metres below the skin
    ridge,  // not negative where a ridge may stand, metres
    turns   // from the middle of the nearest ridge
  };

  [[noreturn]] void fail_too_fine() const {
    const double min = cells_in_strip * reproducible::cbrt(2.0 * volume_of_box() / max_vertices);
    throw Error(ExitStatus::usage, "a strip of " + in_millimetres(options_.strip) + " is too narrow for this fruit",
                "take one at least " + in_millimetres(1.05 * min) + " wide");
  }
  double volume_of_box() const {
    const glm::dvec3 size = depth_.box().high - depth_.box().low;
    return size.x * size.y * size.z;
  }

  std::uint32_t corner(const glm::ivec3& at) const {
    return static_cast<std::uint32_t>(at.x + (cubes_.x + 1) * (at.y + (cubes_.y + 1) * at.z));
  }
  std::uint32_t middle(const glm::ivec3& at) const {
    return corner(cubes_) + 1 + static_cast<std::uint32_t>(at.x + cubes_.x * (at.y + cubes_.y * at.z));
  }

  /// Makes the vertices, first all corners, then all middles, and their values.
  void measure() {
    for (const double shift : {0.0, 0.5}) {
      const glm::ivec3 count = shift == 0 ? cubes_ + 1 : cubes_;
      for (int z = 0; z < count.z; ++z) {
        for (int y = 0; y < count.y; ++y) {
          for (int x = 0; x < count.x; ++x) place_.push_back(low_ + cell_ * (glm::dvec3(x, y, z) + shift));
        }
      }
    }

    // Far from the surface a block's depth does for all its vertices; near it vertices are measured, and pushed off.
    values_.resize(place_.size());
    const std::vector<double> far = depths_far_away();
    parallel_for(place_.size(), {}, [&](std::size_t i) {
      const double known = far[block_of(place_[i])];
      values_[i][depth] = std::isnan(known) ? pushed_off(place_[i]) : known;
      values_[i][turns] = 0;
      values_[i][ridge] = -1;
      if (options_.strip > 0) measure_ridge(place_[i], values_[i]);
    });
    check_thickness();
  }

  /// Some of the fruit itself must remain, not only its stem.
  void check_thickness() const {
    double deepest = 0;
    for (std::size_t i = 0; i < place_.size(); ++i) {
      if (values_[i][depth] < deepest) continue;  // nothing below the skin is deeper
      deepest = std::max(deepest, depth_.below_skin(place_[i]));
      if (deepest > options_.thickness) return;
    }
    throw Error(ExitStatus::usage, "a peel of " + in_millimetres(options_.thickness) + " is thicker than the fruit",
                "its middle lies " + in_millimetres(deepest) + " under the skin");
  }

  /// The grid in blocks of four cubes each way. Exact depths are only needed between the top of a ridge and the offset,
  /// and a cell beyond: in a block that is farther off, the depth of its middle does for all its vertices.
  static constexpr int block = 4;
  glm::ivec3 blocks() const { return cubes_ / block + 1; }
  std::size_t block_of(const glm::dvec3& place) const {
    const glm::ivec3 at = glm::ivec3((place - low_) / (block * cell_));
    return static_cast<std::size_t>(at.x + blocks().x * (at.y + blocks().y * at.z));
  }

  /// Per block: the depth of its middle, or not a number for a block that is near.
  std::vector<double> depths_far_away() const {
    const glm::ivec3 count = blocks();
    std::vector<double> depths(static_cast<std::size_t>(count.x) * count.y * count.z);
    parallel_for(depths.size(), {}, [&](std::size_t i) {
      const int n = static_cast<int>(i);
      const glm::dvec3 at(n % count.x, n / count.x % count.y, n / count.x / count.y);
      const double there = depth_.at(low_ + block * cell_ * (at + 0.5)).depth;
      const double reach = (0.5 * std::sqrt(3.0) * block + ridge_height + 1) * cell_;
      const bool is_far = there < -reach || there > options_.thickness + reach;
      depths[i] = is_far ? there : std::numeric_limits<double>::quiet_NaN();
    });
    return depths;
  }

  /// The depth at a vertex. One that is nearer to the offset than a quarter of a cell is moved away from it to that
  /// distance, so that the surface gets no slivers there. It stays where it is where the move does not help, in
  /// creases.
  double pushed_off(glm::dvec3& place) const {
    const PeelDepth::Place known = depth_.at(place);
    const double above = known.depth - options_.thickness, wanted = 0.25 * cell_;
    if (std::fabs(above) >= wanted) return known.depth;
    const double way = above < 0 ? -wanted - above : wanted - above;
    const glm::dvec3 moved = place + way * known.deeper;
    const double there = depth_.at(moved).depth;
    if ((there < options_.thickness) != (above < 0) || std::fabs(there - options_.thickness) <= std::fabs(above)) {
      return known.depth;
    }
    place = moved;
    return there;
  }

  /// The surface was found as if depth were linear in a tetrahedron. This moves its points to where the depth is the
  /// peel's thickness, by at most a twentieth of a cell.
  ClosedSurface moved_onto_offset(const ClosedSurface& found) const {
    ClosedSurface moved = found;
    parallel_for(moved.point.size(), {}, [&](std::size_t i) {
      const PeelDepth::Place known = depth_.at(found.point[i]);
      const double way = std::clamp(options_.thickness - known.depth, -0.05 * cell_, 0.05 * cell_);
      moved.point[i] += way * known.deeper;
    });

    // Where triangles then cross, in creases, their points move back.
    while (true) {
      DiffusionSurfaces surfaces;
      surfaces.position.assign(moved.point.begin(), moved.point.end());
      surfaces.triangle = moved.triangle;
      bool moved_back = false;
      for (const CrossingTriangles& crossing : crossing_triangles(surfaces)) {
        for (const std::uint32_t t : {crossing.first, crossing.second}) {
          for (int i = 0; i < 3; ++i) {
            glm::dvec3& p = moved.point[moved.triangle[t][i]];
            moved_back = moved_back || p != found.point[moved.triangle[t][i]];
            p = found.point[moved.triangle[t][i]];
          }
        }
      }
      if (!moved_back) return moved;
    }
  }

  /// A ridge reaches from the surface to a little above the skin. It keeps half a strip from either pole and from the
  /// axis, and keeps away from kept bodies.
  void measure_ridge(const glm::dvec3& p, LevelSurface::Values& values) const {
    const double along = outline_.along(p);
    values[turns] = turns_from_ridge(along, p, options_.strip);
    const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
    values[ridge] = std::min({values[depth] + ridge_height * cell_, along - 0.5 * options_.strip,
                              outline_.length() - 0.5 * options_.strip - along, from_axis - 3 * cell_});
    if (values[ridge] < 0) return;
    const double free = ridge_distance * cell_;
    values[ridge] = std::min(values[ridge], depth_.from_what_stays(p, 2 * free) - free);
  }

  template <typename Visit>
  void for_each_tetrahedron(const Visit& visit) const {
    for (int n = 0; n < cubes_.x * cubes_.y * cubes_.z; ++n) {
      const glm::ivec3 cube(n % cubes_.x, n / cubes_.x % cubes_.y, n / cubes_.x / cubes_.y);
      for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 next = cube, u(0), v(0);
        if (++next[axis] >= cubes_[axis]) continue;
        u[(axis + 1) % 3] = 1;
        v[(axis + 2) % 3] = 1;
        const std::array<glm::ivec3, 4> around{next, next + u, next + u + v, next + v};
        for (std::size_t i = 0; i < 4; ++i) {
          visit({middle(cube), middle(next), corner(around[i]), corner(around[(i + 1) % 4])});
        }
      }
    }
  }

  /// There is no ridge where two turns are so near to each other that an edge may belong to either, as deep in a
  /// dimple.
  void end_ridge_where_it_is_steep() {
    std::vector<std::uint32_t> steep;
    for_each_tetrahedron([&](const LevelSurface::Tetrahedron& t) {
      for (const std::uint32_t a : t) {
        for (const std::uint32_t b : t) {
          const LevelSurface::Values &at_a = values_[a], &at_b = values_[b];
          if (at_a[ridge] < 0 || at_b[ridge] < 0) continue;
          if (std::fabs(std::fabs(at_a[turns] - at_b[turns]) - 0.5) < 0.15) steep.push_back(a);
        }
      }
    });
    for (const std::uint32_t vertex : steep) values_[vertex][ridge] = -cell_;
  }

  /// Adds the part of a tetrahedron that the peeler leaves: all deeper than the peel, and the ridge.
  void add(LevelSurface& surface, const LevelSurface::Tetrahedron& t) const {
    // Most tetrahedra are inside or outside as a whole.
    const double half_ridge = 0.5 * ridge_share;
    int deep = 0;
    bool may_have_ridge = false;
    for (const std::uint32_t v : t) {
      const LevelSurface::Values& values = values_[v];
      deep += values[depth] >= options_.thickness ? 1 : 0;
      may_have_ridge = may_have_ridge || values[ridge] >= 0;
    }
    if (deep == 4 || (deep == 0 && !may_have_ridge)) return;

    // Splits the others at the peel's depth and, where a ridge may stand, at its end and both sides.
    std::vector<LevelSurface::Level> levels{{depth, options_.thickness}};
    if (options_.strip > 0) {
      levels.push_back({ridge, 0});
      for (const double side : {-half_ridge, half_ridge}) levels.push_back({turns, side, ridge});
    }
    surface.add(t, levels, [&](const std::array<LevelSurface::Values, 4>& corners) {
      const auto all = [&](const auto& holds) { return std::all_of(corners.begin(), corners.end(), holds); };
      return all([&](const LevelSurface::Values& c) { return c[depth] >= options_.thickness; }) ||
             all([&](const LevelSurface::Values& c) { return c[ridge] >= 0 && std::fabs(c[turns]) <= half_ridge; });
    });
  }

  PeelOptions options_;
  double cell_;
  PeelDepth depth_;
  OutlinePlace outline_;
  glm::ivec3 cubes_{0};
  glm::dvec3 low_{0};

  // Per vertex of the grid.
  std::vector<glm::dvec3> place_;
  std::vector<LevelSurface::Values> values_;
};

/// The ends of edges at which more than two triangles meet: two turns of a ridge may happen to touch along an edge.
std::vector<glm::dvec3> touching_points(const ClosedSurface& surface) {
  std::vector<glm::dvec3> points;
  for_each_edge(sorted_half_edges(surface.triangle), [&](std::span<const HalfEdge> edge) {
    const HalfEdge& h = edge.front();
    if (edge.size() != 2) points.insert(points.end(), {surface.point[h.low], surface.point[h.high]});
  });
  return points;
}

}  // namespace

ClosedSurface peeled(const DiffusionSurfaces& surfaces, const PeelOptions& options) {
  // A ridge that touches itself ends there; if that does not help, the grid is shifted.
  for (const double shift : {0.0, 0.1, -0.1}) {
    PeelGrid grid(surfaces, options, shift);
    while (true) {
      ClosedSurface surface = grid.surface();
      const std::vector<glm::dvec3> touching = touching_points(surface);
      if (touching.empty()) return surface;
      if (!grid.end_ridge_near(touching)) break;
    }
  }
  throw Error(ExitStatus::usage, "this fruit cannot be peeled so: the peel would touch itself",
              "take another thickness, or another width of the strip");
}

}  // namespace pomona
