#include "generator/surface/grains/walls_in_grains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// A triangle of the inner surfaces, or what cores have left of it.
struct WallTriangle {
  std::uint32_t triangle = 0;           ///< of the surfaces
  std::array<std::uint32_t, 3> corner;  ///< points
  std::vector<std::uint32_t> near;      ///< cores whose boxes meet its own
  bool is_gone = false;                 ///< it lies in a core, or its parts follow
};

struct Walls {
  std::vector<WallTriangle> wall;  ///< near cores
  std::vector<glm::dvec3>
      place;  ///< points: the surfaces' vertices, of which walls take the first at a place, and more

  Corners corners(const WallTriangle& w) const { return {place[w.corner[0]], place[w.corner[1]], place[w.corner[2]]}; }
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

Corners corners_of(const DiffusionSurfaces& surfaces, std::uint32_t triangle) {
  const glm::uvec3& v = surfaces.triangle[triangle];
  return {surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]};
}

/// Those of the triangles that are near a core.
Walls walls_near(const std::vector<Core>& cores, const DiffusionSurfaces& surfaces,
                 const std::vector<std::uint32_t>& triangles, Threads threads) {
  std::vector<Box<double>> wall_box, core_box;
  wall_box.reserve(triangles.size()), core_box.reserve(cores.size());
  for (const std::uint32_t t : triangles) wall_box.push_back(box_of(corners_of(surfaces, t)));
  for (const Core& core : cores) core_box.push_back(core.box);
  std::vector<BoxPair> pairs = overlapping_boxes(wall_box, core_box, threads);
  std::sort(pairs.begin(), pairs.end());
  Walls walls;
  walls.place.assign(surfaces.position.begin(), surfaces.position.end());
  const std::vector<std::uint32_t> first = weld(surfaces.position);
  for (const auto& [number, core] : pairs) {
    const std::uint32_t t = triangles[number];
    const glm::uvec3& v = surfaces.triangle[t];
    const std::array<std::uint32_t, 3> corner{first[v.x], first[v.y], first[v.z]};
    if (is_line(corner) || !plane_meets(corners_of(surfaces, t), cores[core].box)) continue;
    if (walls.wall.empty() || walls.wall.back().triangle != t) walls.wall.push_back({t, corner, {}, false});
    walls.wall.back().near.push_back(core);
  }
  return walls;
}

/// A wall and a core whose boxes meet.
using NearCore = BoxPair;

/// What is left of the walls and the cores of one set that are near them: by core, then by wall.
std::vector<NearCore> near_cores(const Walls& walls, const std::vector<Core>& cores, std::uint32_t set) {
  std::vector<NearCore> near;
  for (std::uint32_t w = 0; w < walls.wall.size(); ++w) {
    if (walls.wall[w].is_gone) continue;
    for (const std::uint32_t core : walls.wall[w].near)
      if (cores[core].set == set) near.emplace_back(w, core);
  }
  std::stable_sort(near.begin(), near.end(), [](const NearCore& a, const NearCore& b) { return a.second < b.second; });
  return near;
}

/// The walls that cores cross, and where. Adds points to the walls'.
CrossedSet crossed_walls(Walls& walls, const std::vector<Core>& cores, const std::vector<NearCore>& near,
                         Threads threads) {
  std::vector<BodyFacet> wall_facet, core_facet;
  wall_facet.reserve(walls.wall.size());
  for (const WallTriangle& wall : walls.wall) wall_facet.push_back({wall.corner, 0});
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
      const Box<double> wall = box_of(walls.corners(walls.wall[near[end].first]));
      for (std::uint32_t f = 0; f < box.size(); ++f) {
        if (wall.meets(box[f])) pairs.emplace_back(near[end].first, begin + f);
      }
    }
  }
  return body_crossings(wall_facet, core_facet, pairs, walls.place, threads).first;
}

bool lies_in(const Core& core, const glm::dvec3& point) {
  if (!core.box.meets({point, point})) return false;
  int winding = 0;
  for (std::size_t f = 0; f < core.facet.size(); ++f) winding += winding_of_knife(core.corners(f), point);
  return winding > 0;
}

/// Puts the parts of a wall that lie outside cores behind the walls, each with the cores that are near it.
void part_wall(Walls& walls, std::uint32_t number, const std::vector<FacetPart>& parts,
               const std::vector<Core>& cores) {
  walls.wall[number].is_gone = true;
  for (const FacetPart& part : parts) {
    if (part.inside != FacetPart::outside) continue;
    const WallTriangle& whole = walls.wall[number];
    WallTriangle wall{whole.triangle, part.corner, {}, false};
    const Corners corners = walls.corners(wall);
    for (const std::uint32_t core : whole.near)
      if (cores[core].box.meets(box_of(corners)) && plane_meets(corners, cores[core].box)) wall.near.push_back(core);
    walls.wall.push_back(std::move(wall));
  }
}

/// Takes what lies in cores of one set out of the walls. A wall whose parts cannot be told, because a grain crosses
/// itself there, is left whole.
void part_walls(Walls& walls, const std::vector<Core>& cores, std::uint32_t set, Threads threads) {
  const std::vector<NearCore> near = near_cores(walls, cores, set);
  const CrossedSet crossed = crossed_walls(walls, cores, near, threads);
  std::vector<std::uint8_t> is_crossed(walls.wall.size(), 0);
  for (const std::uint32_t wall : crossed.crossed) is_crossed[wall] = 1;
  for (const auto& [number, core] : near) {
    WallTriangle& wall = walls.wall[number];
    // The corners of a wall that nothing crosses lie on one side.
    if (is_crossed[number] == 0 && !wall.is_gone) wall.is_gone = lies_in(cores[core], walls.place[wall.corner[0]]);
  }
  for (std::size_t i = 0; i < crossed.crossed.size(); ++i) {
    const std::optional<std::vector<FacetPart>> parts = parts_of(crossed.facet[i], walls.place);
    if (parts) part_wall(walls, crossed.crossed[i], *parts, cores);
  }
}

/// Puts what is left of walls in their place. Vertices are numbered in the order of their use, as reading a file of the
/// result would number them.
class WallReplacer {
  static constexpr std::uint32_t unset = 0xffffffffu;

 public:
  WallReplacer(const DiffusionSurfaces& surfaces, const Walls& walls)
      : from_(surfaces), walls_(walls), copy_of_(surfaces.vertex_count(), unset) {
    to_.surface_names = surfaces.surface_names;
    to_.part_names = surfaces.part_names;
    to_.notes = surfaces.notes;
  }

  DiffusionSurfaces run() {
    std::vector<const WallTriangle*> order;
    for (const WallTriangle& wall : walls_.wall) order.push_back(&wall);
    std::stable_sort(order.begin(), order.end(),
                     [](const WallTriangle* a, const WallTriangle* b) { return a->triangle < b->triangle; });
    auto next = order.begin();
    for (std::uint32_t t = 0; t < from_.triangle_count(); ++t) {
      vertex_of_.clear();
      const auto is_of_it = [&] { return next != order.end() && (*next)->triangle == t; };
      if (!is_of_it()) add_whole(t);
      for (; is_of_it(); ++next)
        if (!(*next)->is_gone) add_wall(**next);
    }
    return std::move(to_);
  }

 private:
  void add_whole(std::uint32_t source) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) corners[k] = copy_of(from_.triangle[source][k]);
    add(source, corners);
  }

  void add_wall(const WallTriangle& wall) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) corners[k] = vertex_at(wall.triangle, wall.corner[static_cast<std::size_t>(k)]);
    add(wall.triangle, corners);
  }

  void add(std::uint32_t source, const glm::uvec3& corners) {
    to_.triangle.push_back(corners);
    to_.surface.push_back(from_.surface[source]);
    to_.front_part.push_back(from_.front_part[source]);
    to_.back_part.push_back(from_.back_part[source]);
    if (!from_.instance.empty()) to_.instance.push_back(from_.instance[source]);
  }

  std::uint32_t vertex_at(std::uint32_t source, std::uint32_t point) {
    const glm::uvec3& whole = from_.triangle[source];
    if (point < from_.vertex_count()) return copy_of(corner_at(whole, point));
    for (const auto& [known, vertex] : vertex_of_)
      if (known == point) return vertex;
    vertex_of_.emplace_back(point, add_vertex_within(to_, from_, whole, walls_.place[point]));
    return vertex_of_.back().second;
  }

  std::uint32_t corner_at(const glm::uvec3& whole, std::uint32_t point) const {
    const glm::vec3 place(walls_.place[point]);
    return from_.position[whole.x] == place ? whole.x : from_.position[whole.y] == place ? whole.y : whole.z;
  }

  std::uint32_t copy_of(std::uint32_t vertex) {
    if (copy_of_[vertex] == unset) copy_of_[vertex] = add_vertex(to_, from_, vertex);
    return copy_of_[vertex];
  }

  const DiffusionSurfaces& from_;
  const Walls& walls_;
  std::vector<std::uint32_t> copy_of_;  // per vertex
  DiffusionSurfaces to_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertex_of_;  // of one triangle: new points and their vertices
};

}  // namespace

DiffusionSurfaces without_walls_in_grains(DiffusionSurfaces walls, const DiffusionSurfaces& grains,
                                          std::span<const int> spared, Threads threads) {
  const std::vector<std::uint32_t> inner = inner_triangles(walls, spared);
  if (inner.empty() || grains.triangle.empty()) return walls;
  const std::vector<Core> cores = cores_of(grains);
  Walls left = walls_near(cores, walls, inner, threads);
  const auto last = std::max_element(cores.begin(), cores.end(), [](auto& a, auto& b) { return a.set < b.set; });
  for (std::uint32_t set = 0; set <= last->set; ++set) part_walls(left, cores, set, threads);
  if (std::none_of(left.wall.begin(), left.wall.end(), [](const WallTriangle& wall) { return wall.is_gone; }))
    return walls;
  return WallReplacer(walls, left).run();
}

}  // namespace pomona
