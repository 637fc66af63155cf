#include "generator/surface/grains/walls_in_grains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/connected_vertices.h"
#include "generator/mesh/crossings/body_crossings.h"
#include "generator/mesh/crossings/tie_rule.h"
#include "generator/mesh/overlapping_boxes.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// Grains are that much smaller where walls end at them.
constexpr double core_size = 0.95;

/// A grain of its smaller size.
struct Core {
  std::vector<glm::dvec3> point;
  std::vector<std::array<std::uint32_t, 3>> facet;  ///< points; those at one place are one
  Box<double> box;
  std::uint32_t set = 0;  ///< the boxes of a set lie apart

  Corners corners(std::size_t f) const { return {point[facet[f][0]], point[facet[f][1]], point[facet[f][2]]}; }
};

/// A triangle of the inner surfaces, or a part of one.
struct WallTriangle {
  std::uint32_t source = 0;  ///< triangle of the surfaces
  glm::uvec3 vertex{0};
  std::vector<std::uint32_t> near = {};  ///< cores whose boxes meet its own
  bool is_gone = false;                  ///< it lies in a core, or its parts replace it
  std::size_t parts = 0, end = 0;        ///< walls: those parts
};

/// The surfaces, with vertices of parts behind theirs, and the walls near cores: triangles in their order, then parts.
struct WalledSurfaces {
  DiffusionSurfaces surfaces;
  std::vector<WallTriangle> wall;
};

Box<double> box_of(const Corners& c) { return box_around(c[0], c[1], c[2]); }

/// True unless the triangle's plane passes the box by.
bool plane_meets(const Corners& c, const Box<double>& box) {
  const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
  const double reach = glm::dot(glm::abs(normal), 0.5 * box.size());
  return std::fabs(glm::dot(normal, box.center() - c[0])) <= (1 + 1e-9) * reach;  // rounding takes less
}

bool is_line(const std::array<std::uint32_t, 3>& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; }

/// The cores, with their sets.
std::vector<Core> in_sets(std::vector<Core> cores) {
  std::vector<Box<float>> box;
  box.reserve(cores.size());
  for (const Core& core : cores) box.push_back({glm::vec3(core.box.low), glm::vec3(core.box.high)});
  std::vector<std::vector<std::uint32_t>> met(cores.size());  // earlier ones
  for (const auto& [a, b] : overlapping_boxes(box)) met[b].push_back(a);
  for (std::size_t c = 0; c < cores.size(); ++c) {
    const auto is_taken = [&](std::uint32_t set) {
      return std::any_of(met[c].begin(), met[c].end(), [&](std::uint32_t other) { return cores[other].set == set; });
    };
    while (is_taken(cores[c].set)) ++cores[c].set;
  }
  return cores;
}

/// Each grain, smaller about the middle of its box.
std::vector<Core> cores_of(const DiffusionSurfaces& grains) {
  constexpr std::uint32_t unset = 0xffffffffu;
  const std::vector<std::uint32_t> first = weld(grains.position);
  DisjointSets sets = connected_vertices(grains.vertex_count(), grains.triangle);
  std::vector<std::uint32_t> core_of(grains.vertex_count(), unset), point_of(grains.vertex_count(), unset);
  std::vector<Core> cores;
  for (const glm::uvec3& t : grains.triangle) {
    std::uint32_t& number = core_of[sets.root(t.x)];
    if (number == unset) {
      number = static_cast<std::uint32_t>(cores.size());
      cores.emplace_back();
    }
    Core& core = cores[number];
    std::array<std::uint32_t, 3> corner{};
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& point = point_of[first[t[k]]];
      if (point == unset) {
        point = static_cast<std::uint32_t>(core.point.size());
        core.point.emplace_back(grains.position[t[k]]);
        core.box.add(core.point.back());
      }
      corner[static_cast<std::size_t>(k)] = point;
    }
    if (!is_line(corner)) core.facet.push_back(corner);
  }
  for (Core& core : cores) {
    const glm::dvec3 middle = core.box.center();
    for (glm::dvec3& p : core.point) p = glm::mix(middle, p, core_size);
    core.box = box_around(core.point);
  }
  return in_sets(std::move(cores));
}

/// The inner surfaces, but for those around spared parts.
std::vector<std::uint32_t> inner_triangles(const DiffusionSurfaces& surfaces, std::span<const int> spared) {
  const auto is_spared = [&](int part) { return std::find(spared.begin(), spared.end(), part) != spared.end(); };
  std::vector<std::uint32_t> inner;
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (!surfaces.is_boundary(t) && is_spared(surfaces.front_part[t]) == is_spared(surfaces.back_part[t]))
      inner.push_back(t);
  }
  return inner;
}

Corners corners_of(const DiffusionSurfaces& surfaces, const glm::uvec3& vertex) {
  return {surfaces.position[vertex.x], surfaces.position[vertex.y], surfaces.position[vertex.z]};
}

/// Those of the triangles that are near a core.
std::vector<WallTriangle> walls_near(const std::vector<Core>& cores, const DiffusionSurfaces& surfaces,
                                     const std::vector<std::uint32_t>& triangles, Threads threads) {
  std::vector<Box<double>> wall_box, core_box;
  wall_box.reserve(triangles.size()), core_box.reserve(cores.size());
  for (const std::uint32_t t : triangles) wall_box.push_back(box_of(corners_of(surfaces, surfaces.triangle[t])));
  for (const Core& core : cores) core_box.push_back(core.box);
  std::vector<BoxPair> pairs = overlapping_boxes(wall_box, core_box, threads);
  std::sort(pairs.begin(), pairs.end());
  std::vector<WallTriangle> walls;
  for (const auto& [number, core] : pairs) {
    const std::uint32_t t = triangles[number];
    if (!plane_meets(corners_of(surfaces, surfaces.triangle[t]), cores[core].box)) continue;
    if (walls.empty() || walls.back().source != t) walls.push_back({.source = t, .vertex = surfaces.triangle[t]});
    walls.back().near.push_back(core);
  }
  return walls;
}

/// A wall and a core whose boxes meet.
using NearCore = BoxPair;

/// The walls near the cores of a set as facets of body 0, between points: their vertices, of which facets take the
/// first at a place.
struct WallFacets {
  std::vector<std::uint32_t> wall;
  std::vector<BodyFacet> facet;  ///< of each
  std::vector<glm::dvec3> place;
  std::vector<NearCore> near;  ///< facets that are no lines, and the cores near them
};

/// What is left of the walls and the cores of one set that are near them: by core, then by wall.
std::vector<NearCore> near_cores(const WalledSurfaces& all, const std::vector<Core>& cores, std::uint32_t set) {
  std::vector<NearCore> near;
  for (std::uint32_t w = 0; w < all.wall.size(); ++w) {
    if (all.wall[w].is_gone) continue;
    for (const std::uint32_t core : all.wall[w].near)
      if (cores[core].set == set) near.emplace_back(w, core);
  }
  std::stable_sort(near.begin(), near.end(), [](const NearCore& a, const NearCore& b) { return a.second < b.second; });
  return near;
}

/// In the order of the walls and of their vertices.
WallFacets facets_of(const WalledSurfaces& all, std::vector<NearCore> near) {
  constexpr std::uint32_t unset = 0xffffffffu;
  std::vector<std::uint32_t> number(all.wall.size(), unset), point_of(all.surfaces.vertex_count(), unset);
  WallFacets walls{.wall = {}, .facet = {}, .place = {}, .near = std::move(near)};
  for (const auto& [wall, core] : walls.near) number[wall] = 0;
  for (std::uint32_t w = 0; w < all.wall.size(); ++w) {
    if (number[w] == unset) continue;
    number[w] = static_cast<std::uint32_t>(walls.wall.size());
    walls.wall.push_back(w);
    for (int k = 0; k < 3; ++k) point_of[all.wall[w].vertex[k]] = 0;
  }
  for (auto& [wall, core] : walls.near) wall = number[wall];
  std::vector<glm::vec3> position;
  for (std::uint32_t v = 0; v < point_of.size(); ++v) {
    if (point_of[v] == unset) continue;
    point_of[v] = static_cast<std::uint32_t>(position.size());
    position.push_back(all.surfaces.position[v]);
  }
  walls.place.assign(position.begin(), position.end());
  const std::vector<std::uint32_t> first = weld(position);
  for (const std::uint32_t w : walls.wall) {
    const glm::uvec3& v = all.wall[w].vertex;
    walls.facet.push_back({{first[point_of[v.x]], first[point_of[v.y]], first[point_of[v.z]]}, 0});
  }
  std::erase_if(walls.near, [&](const NearCore& near_core) { return is_line(walls.facet[near_core.first].corner); });
  return walls;
}

/// The walls that cores cross, and where. Adds points to the walls'.
CrossedSet crossed_walls(WallFacets& walls, const std::vector<Core>& cores, Threads threads) {
  const std::vector<NearCore>& near = walls.near;
  std::vector<BodyFacet> core_facet;
  std::vector<BoxPair> pairs;
  std::vector<Box<double>> box;
  for (std::size_t i = 0, end; i < near.size(); i = end) {
    const Core& core = cores[near[i].second];
    const auto points = static_cast<std::uint32_t>(walls.place.size());
    const auto begin = static_cast<std::uint32_t>(core_facet.size());
    walls.place.insert(walls.place.end(), core.point.begin(), core.point.end());
    box.clear();
    for (std::size_t f = 0; f < core.facet.size(); ++f) {
      const auto& [a, b, c] = core.facet[f];
      core_facet.push_back({{points + a, points + b, points + c}, static_cast<std::int32_t>(near[i].second)});
      box.push_back(box_of(core.corners(f)));
    }
    for (end = i; end < near.size() && near[end].second == near[i].second; ++end) {
      const auto& [a, b, c] = walls.facet[near[end].first].corner;
      const Box<double> wall = box_of({walls.place[a], walls.place[b], walls.place[c]});
      for (std::uint32_t f = 0; f < box.size(); ++f) {
        if (wall.meets(box[f])) pairs.emplace_back(near[end].first, begin + f);
      }
    }
  }
  return body_crossings(walls.facet, core_facet, pairs, walls.place, threads).first;
}

bool lies_in(const Core& core, const glm::dvec3& point) {
  if (!core.box.meets({point, point})) return false;
  int winding = 0;
  for (std::size_t f = 0; f < core.facet.size(); ++f) winding += winding_of_knife(core.corners(f), point);
  return winding > 0;
}

/// Puts the parts of a wall that lie outside cores behind the walls, each with the cores that are near it.
void part_wall(WalledSurfaces& all, std::uint32_t facet, const std::vector<FacetPart>& parts, const WallFacets& facets,
               const std::vector<Core>& cores) {
  const std::uint32_t number = facets.wall[facet];
  const WallTriangle whole = all.wall[number];
  std::map<std::uint32_t, std::uint32_t> vertex_of;  // by point
  for (int k = 0; k < 3; ++k) vertex_of[facets.facet[facet].corner[static_cast<std::size_t>(k)]] = whole.vertex[k];
  const auto vertex_at = [&](std::uint32_t point) {
    const auto [known, is_new] = vertex_of.try_emplace(point, 0);
    if (is_new) known->second = add_vertex_within(all.surfaces, all.surfaces, whole.vertex, facets.place[point]);
    return known->second;
  };
  const std::size_t begin = all.wall.size();
  for (const FacetPart& part : parts) {
    if (part.inside != FacetPart::outside) continue;
    WallTriangle wall{.source = whole.source};
    for (int k = 0; k < 3; ++k) wall.vertex[k] = vertex_at(part.corner[static_cast<std::size_t>(k)]);
    const Corners corners = corners_of(all.surfaces, wall.vertex);
    for (const std::uint32_t core : whole.near)
      if (cores[core].box.meets(box_of(corners)) && plane_meets(corners, cores[core].box)) wall.near.push_back(core);
    all.wall.push_back(std::move(wall));
  }
  all.wall[number].is_gone = true;
  all.wall[number].parts = begin, all.wall[number].end = all.wall.size();
}

/// The same without what lies in cores of one set. A wall whose parts cannot be told, because a grain crosses itself
/// there, is left whole.
WalledSurfaces parted(WalledSurfaces all, const std::vector<Core>& cores, std::uint32_t set, Threads threads) {
  WallFacets facets = facets_of(all, near_cores(all, cores, set));
  const CrossedSet crossed = crossed_walls(facets, cores, threads);
  std::vector<std::uint8_t> is_crossed(facets.wall.size(), 0);
  for (const std::uint32_t facet : crossed.crossed) is_crossed[facet] = 1;
  for (const auto& [facet, core] : facets.near) {
    bool& is_gone = all.wall[facets.wall[facet]].is_gone;
    // The corners of a wall that nothing crosses lie on one side.
    if (is_crossed[facet] == 0 && !is_gone) is_gone = lies_in(cores[core], facets.place[facets.facet[facet].corner[0]]);
  }
  for (std::size_t i = 0; i < crossed.crossed.size(); ++i) {
    const std::optional<std::vector<FacetPart>> parts = parts_of(crossed.facet[i], facets.place);
    if (parts) part_wall(all, crossed.crossed[i], *parts, facets, cores);
  }
  return all;
}

/// Puts what is left of walls in their place. Vertices are numbered in the order of their use, as reading a file of the
/// result would number them.
class WallReplacer {
  static constexpr std::uint32_t unset = 0xffffffffu;

 public:
  explicit WallReplacer(const WalledSurfaces& all)
      : from_(all.surfaces), wall_(all.wall), copy_of_(all.surfaces.vertex_count(), unset) {
    to_.surface_names = from_.surface_names;
    to_.part_names = from_.part_names;
    to_.notes = from_.notes;
  }

  DiffusionSurfaces run() {
    auto next = wall_.begin();
    for (std::uint32_t t = 0; t < from_.triangle_count(); ++t) {
      if (next != wall_.end() && next->source == t)
        add_left(*next++);
      else
        add(t, from_.triangle[t]);
    }
    return std::move(to_);
  }

 private:
  void add_left(const WallTriangle& wall) {
    if (!wall.is_gone) add(wall.source, wall.vertex);
    for (std::size_t part = wall.parts; part < wall.end; ++part) add_left(wall_[part]);
  }

  void add(std::uint32_t source, const glm::uvec3& vertex) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) corners[k] = copy_of(vertex[k]);
    to_.triangle.push_back(corners);
    to_.surface.push_back(from_.surface[source]);
    to_.front_part.push_back(from_.front_part[source]);
    to_.back_part.push_back(from_.back_part[source]);
    if (!from_.instance.empty()) to_.instance.push_back(from_.instance[source]);
  }

  std::uint32_t copy_of(std::uint32_t vertex) {
    if (copy_of_[vertex] == unset) copy_of_[vertex] = add_vertex(to_, from_, vertex);
    return copy_of_[vertex];
  }

  const DiffusionSurfaces& from_;
  const std::vector<WallTriangle>& wall_;
  std::vector<std::uint32_t> copy_of_;  // per vertex
  DiffusionSurfaces to_;
};

}  // namespace

DiffusionSurfaces without_walls_in_grains(DiffusionSurfaces walls, const DiffusionSurfaces& grains,
                                          std::span<const int> spared, Threads threads) {
  const std::vector<std::uint32_t> inner = inner_triangles(walls, spared);
  if (inner.empty() || grains.triangle.empty()) return walls;
  const std::vector<Core> cores = cores_of(grains);
  std::vector<WallTriangle> near = walls_near(cores, walls, inner, threads);
  WalledSurfaces all{std::move(walls), std::move(near)};
  const auto last = std::max_element(cores.begin(), cores.end(), [](auto& a, auto& b) { return a.set < b.set; });
  for (std::uint32_t set = 0; set <= last->set; ++set) all = parted(std::move(all), cores, set, threads);
  const bool changed = std::any_of(all.wall.begin(), all.wall.end(), [](const WallTriangle& w) { return w.is_gone; });
  return changed ? WallReplacer(all).run() : std::move(all.surfaces);
}

}  // namespace pomona
