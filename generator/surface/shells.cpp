#include "generator/surface/shells.h"

#include <algorithm>
#include <span>
#include <utility>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "generator/surface/edge_leaves.h"

namespace pomona {

namespace {

class ShellFinder {
 public:
  explicit ShellFinder(const DiffusionSurfaces& surfaces)
      : surfaces_(surfaces), sets_(surfaces.triangle_count()), open_(surfaces.triangle_count(), 0) {}

  Shells find() {
    shells_.air_facing = air_facing_triangles();
    for_each_edge(sorted_half_edges(boundary_only()), [&](std::span<const HalfEdge> edge) { join_across(edge); });
    number_shells();
    adopt_collapsed_triangles();
    return std::move(shells_);
  }

 private:
  /// A triangle whose back is hidden faces air the other way round.
  std::vector<glm::uvec3> air_facing_triangles() const {
    std::vector<glm::uvec3> triangles = welded_triangles(weld(surfaces_.position), surfaces_.triangle);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (surfaces_.is_hidden(i, SideOf::back)) std::swap(triangles[i].y, triangles[i].z);
    }
    return triangles;
  }

  /// Inner triangles collapsed, so that they have no edges.
  std::vector<glm::uvec3> boundary_only() const {
    std::vector<glm::uvec3> triangles = shells_.air_facing;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (!surfaces_.is_boundary(i)) triangles[i] = glm::uvec3(0);
    }
    return triangles;
  }

  void join_across(std::span<const HalfEdge> edge) {
    if (balance(edge) != 0) {
      for (const HalfEdge& h : edge) open_[h.triangle] = 1;
    }
    // So many triangles at one edge are no solid; keeping them together is cheapest.
    constexpr std::size_t crowd = 64;
    if (edge.size() <= 2 || edge.size() > crowd) {
      for (const HalfEdge& h : edge) sets_.join(edge.front().triangle, h.triangle);
    } else {
      join_wedges(leaves_around(edge, shells_.air_facing, surfaces_.position));
    }
  }

  /// Joins each triangle where solid starts with the one where it ends, like brackets, those of one surface first.
  void join_wedges(std::vector<EdgeLeaf> leaves) {
    const auto surface_of = [&](const EdgeLeaf& leaf) { return surfaces_.surface[leaf.triangle]; };
    const auto join_one = [&](bool same_surface) {
      for (std::size_t i = 0; i < leaves.size(); ++i) {
        const std::size_t next = (i + 1) % leaves.size();
        if (leaves[i].forward || !leaves[next].forward) continue;
        if (same_surface && surface_of(leaves[i]) != surface_of(leaves[next])) continue;
        sets_.join(leaves[i].triangle, leaves[next].triangle);
        leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
        leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
        return true;
      }
      return false;
    };
    while (leaves.size() >= 2 && (join_one(true) || join_one(false))) continue;
  }

  void number_shells() {
    const std::size_t triangles = surfaces_.triangle_count();
    shells_.of_triangle.assign(triangles, Shells::none);
    std::vector<std::int32_t> number(triangles, Shells::none);
    std::vector<std::uint8_t> is_open(surfaces_.surface_names.size(), 0);
    for (std::uint32_t i = 0; i < triangles; ++i) {
      if (!surfaces_.is_boundary(i) || is_collapsed(shells_.air_facing[i])) continue;
      std::int32_t& shell = number[sets_.root(i)];
      if (shell == Shells::none) {
        shell = static_cast<std::int32_t>(shells_.count());
        shells_.closed.push_back(1);
      }
      shells_.of_triangle[i] = shell;
      if (open_[i] == 0) continue;
      shells_.closed[static_cast<std::size_t>(shell)] = 0;
      is_open[static_cast<std::size_t>(surfaces_.surface[i])] = 1;
    }
    for (std::size_t s = 0; s < is_open.size(); ++s) {
      if (is_open[s] != 0) shells_.open_surfaces.push_back(static_cast<std::int32_t>(s));
    }
  }

  /// A boundary triangle without area belongs to a shell that it touches.
  void adopt_collapsed_triangles() {
    std::vector<std::int32_t> shell_at(surfaces_.vertex_count(), Shells::none);
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      if (shells_.of_triangle[i] == Shells::none) continue;
      for (int k = 0; k < 3; ++k) shell_at[shells_.air_facing[i][k]] = shells_.of_triangle[i];
    }
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      const glm::uvec3& t = shells_.air_facing[i];
      if (!surfaces_.is_boundary(i) || !is_collapsed(t)) continue;
      shells_.of_triangle[i] = std::max({shell_at[t.x], shell_at[t.y], shell_at[t.z]});
    }
  }

  const DiffusionSurfaces& surfaces_;
  DisjointSets sets_;
  std::vector<std::uint8_t> open_;  ///< per triangle: has an unmatched edge
  Shells shells_;
};

}  // namespace

Shells find_shells(const DiffusionSurfaces& surfaces) { return ShellFinder(surfaces).find(); }

}  // namespace pomona
