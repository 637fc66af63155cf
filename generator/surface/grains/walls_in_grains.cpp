#include "generator/surface/grains/walls_in_grains.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

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

  Corners corners(std::size_t f) const { return {point[facet[f][0]], point[facet[f][1]], point[facet[f][2]]}; }
};

/// Triangles that may end in a core.
struct Walls {
  std::vector<std::uint32_t> triangle;  ///< of the surfaces
  std::vector<BodyFacet> facet;         ///< the same; of body 0
  std::vector<Box<double>> box;
  std::vector<glm::dvec3> place;  ///< points: the surfaces' vertices, of which facets take the first at a place
};

Box<double> box_of(const Corners& c) { return box_around(c[0], c[1], c[2]); }

bool is_line(const std::array<std::uint32_t, 3>& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; }

/// The inner surfaces, but for those around spared parts.
Walls inner_walls(const DiffusionSurfaces& surfaces, std::span<const int> spared) {
  const auto is_spared = [&](int part) { return std::find(spared.begin(), spared.end(), part) != spared.end(); };
  const std::vector<std::uint32_t> first = weld(surfaces.position);
  Walls walls;
  walls.place.assign(surfaces.position.begin(), surfaces.position.end());
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (surfaces.is_boundary(t) || is_spared(surfaces.front_part[t]) != is_spared(surfaces.back_part[t])) continue;
    const glm::uvec3& v = surfaces.triangle[t];
    const BodyFacet facet{{first[v.x], first[v.y], first[v.z]}, 0};
    if (is_line(facet.corner)) continue;
    walls.triangle.push_back(t);
    walls.facet.push_back(facet);
    walls.box.push_back(box_of({walls.place[v.x], walls.place[v.y], walls.place[v.z]}));
  }
  return walls;
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
  return cores;
}

/// The cores in sets; the boxes of a set lie apart.
std::vector<std::vector<Core>> sets_apart(std::vector<Core> cores) {
  std::vector<Box<float>> box;
  box.reserve(cores.size());
  for (const Core& core : cores) box.push_back({glm::vec3(core.box.low), glm::vec3(core.box.high)});
  std::vector<std::vector<std::uint32_t>> met(cores.size());  // earlier ones
  for (const auto& [a, b] : overlapping_boxes(box)) met[b].push_back(a);
  std::vector<std::vector<Core>> sets;
  std::vector<std::size_t> set_of(cores.size());
  for (std::size_t c = 0; c < cores.size(); ++c) {
    const auto is_taken = [&](std::size_t set) {
      return std::any_of(met[c].begin(), met[c].end(), [&](std::uint32_t other) { return set_of[other] == set; });
    };
    while (is_taken(set_of[c])) ++set_of[c];
    if (set_of[c] == sets.size()) sets.emplace_back();
    sets[set_of[c]].push_back(std::move(cores[c]));
  }
  return sets;
}

/// A wall whose box meets that of a core.
using NearCore = BoxPair;

std::vector<NearCore> near_cores(const Walls& walls, const std::vector<Core>& cores, Threads threads) {
  std::vector<Box<double>> box;
  box.reserve(cores.size());
  for (const Core& core : cores) box.push_back(core.box);
  return overlapping_boxes(walls.box, box, threads);
}

/// The walls that cores cross, and where. Adds points to the walls'.
CrossedSet crossed_walls(Walls& walls, const std::vector<Core>& cores, std::vector<NearCore> near, Threads threads) {
  std::stable_sort(near.begin(), near.end(), [](const NearCore& a, const NearCore& b) { return a.second < b.second; });
  std::vector<BodyFacet> facets;
  std::vector<BoxPair> pairs;
  std::vector<Box<double>> box;
  for (std::size_t i = 0, end; i < near.size(); i = end) {
    const Core& core = cores[near[i].second];
    const auto points = static_cast<std::uint32_t>(walls.place.size());
    const auto begin = static_cast<std::uint32_t>(facets.size());
    walls.place.insert(walls.place.end(), core.point.begin(), core.point.end());
    box.clear();
    for (std::size_t f = 0; f < core.facet.size(); ++f) {
      const auto& [a, b, c] = core.facet[f];
      facets.push_back({{points + a, points + b, points + c}, static_cast<std::int32_t>(near[i].second)});
      box.push_back(box_of(core.corners(f)));
    }
    for (end = i; end < near.size() && near[end].second == near[i].second; ++end) {
      for (std::uint32_t f = 0; f < box.size(); ++f) {
        if (walls.box[near[end].first].meets(box[f])) pairs.emplace_back(near[end].first, begin + f);
      }
    }
  }
  return body_crossings(walls.facet, facets, pairs, walls.place, threads).first;
}

bool lies_in(const Core& core, const glm::dvec3& point) {
  if (!core.box.meets({point, point})) return false;
  int winding = 0;
  for (std::size_t f = 0; f < core.facet.size(); ++f) winding += winding_of_knife(core.corners(f), point);
  return winding > 0;
}

/// What is left of walls. One whose parts cannot be told, because a grain crosses itself there, is left whole.
struct Left {
  std::vector<std::uint8_t> is_gone;          ///< per wall: replaced by its parts, if it has any
  std::vector<std::vector<FacetPart>> parts;  ///< per crossed wall: those outside all cores
};

Left left_of(const Walls& walls, const std::vector<Core>& cores, const std::vector<NearCore>& near,
             const CrossedSet& crossed) {
  Left left{std::vector<std::uint8_t>(walls.facet.size(), 0),
            std::vector<std::vector<FacetPart>>(crossed.crossed.size())};
  std::vector<std::uint8_t> is_crossed(walls.facet.size(), 0);
  for (std::size_t i = 0; i < crossed.crossed.size(); ++i) {
    is_crossed[crossed.crossed[i]] = 1;
    std::optional<std::vector<FacetPart>> parts = parts_of(crossed.facet[i], walls.place);
    if (!parts) continue;
    left.is_gone[crossed.crossed[i]] = 1;
    std::erase_if(*parts, [](const FacetPart& part) { return part.inside != FacetPart::outside; });
    left.parts[i] = std::move(*parts);
  }
  for (const auto& [wall, core] : near) {
    if (is_crossed[wall] != 0 || left.is_gone[wall] != 0) continue;
    // The corners of a wall that nothing crosses lie on one side.
    if (lies_in(cores[core], walls.place[walls.facet[wall].corner[0]])) left.is_gone[wall] = 1;
  }
  return left;
}

/// Puts the parts of walls in place of those that are gone. Vertices are numbered in the order of their use, as reading
/// a file of the result would number them.
class WallParter {
  static constexpr std::uint32_t unset = 0xffffffffu;

 public:
  WallParter(const DiffusionSurfaces& surfaces, const Walls& walls)
      : from_(surfaces), walls_(walls), copy_of_(surfaces.vertex_count(), unset) {
    to_.surface_names = surfaces.surface_names;
    to_.part_names = surfaces.part_names;
    to_.notes = surfaces.notes;
  }

  DiffusionSurfaces run(const CrossedSet& crossed, const Left& left) {
    std::uint32_t wall = 0, next = 0;
    for (std::uint32_t t = 0; t < from_.triangle_count(); ++t) {
      const bool is_wall = wall < walls_.triangle.size() && walls_.triangle[wall] == t;
      if (!is_wall || left.is_gone[wall] == 0) add_whole(t);
      if (!is_wall) continue;
      if (next < crossed.crossed.size() && crossed.crossed[next] == wall) add_parts(wall, left.parts[next++]);
      ++wall;
    }
    return std::move(to_);
  }

 private:
  void add_whole(std::uint32_t source) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) corners[k] = copy_of(from_.triangle[source][k]);
    add(source, corners);
  }

  void add_parts(std::uint32_t wall, const std::vector<FacetPart>& parts) {
    vertex_of_.clear();
    for (const FacetPart& part : parts) {
      glm::uvec3 corners;
      for (int k = 0; k < 3; ++k) corners[k] = vertex_at(wall, part.corner[static_cast<std::size_t>(k)]);
      add(walls_.triangle[wall], corners);
    }
  }

  void add(std::uint32_t source, const glm::uvec3& corners) {
    to_.triangle.push_back(corners);
    to_.surface.push_back(from_.surface[source]);
    to_.front_part.push_back(from_.front_part[source]);
    to_.back_part.push_back(from_.back_part[source]);
    if (!from_.instance.empty()) to_.instance.push_back(from_.instance[source]);
  }

  std::uint32_t vertex_at(std::uint32_t wall, std::uint32_t point) {
    const glm::uvec3& whole = from_.triangle[walls_.triangle[wall]];
    for (int k = 0; k < 3; ++k)
      if (walls_.facet[wall].corner[static_cast<std::size_t>(k)] == point) return copy_of(whole[k]);
    for (const auto& [known, vertex] : vertex_of_)
      if (known == point) return vertex;
    vertex_of_.emplace_back(point, add_vertex_within(to_, from_, whole, walls_.place[point]));
    return vertex_of_.back().second;
  }

  std::uint32_t copy_of(std::uint32_t vertex) {
    if (copy_of_[vertex] == unset) copy_of_[vertex] = add_vertex(to_, from_, vertex);
    return copy_of_[vertex];
  }

  const DiffusionSurfaces& from_;
  const Walls& walls_;
  std::vector<std::uint32_t> copy_of_;  // per vertex
  DiffusionSurfaces to_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertex_of_;  // of one wall: new points and their vertices
};

/// The surfaces without what of their walls lies within cores whose boxes lie apart.
DiffusionSurfaces without_walls_in(const std::vector<Core>& cores, DiffusionSurfaces surfaces,
                                   std::span<const int> spared, Threads threads) {
  Walls walls = inner_walls(surfaces, spared);
  const std::vector<NearCore> near = near_cores(walls, cores, threads);
  if (near.empty()) return surfaces;
  const CrossedSet crossed = crossed_walls(walls, cores, near, threads);
  const Left left = left_of(walls, cores, near, crossed);
  if (std::find(left.is_gone.begin(), left.is_gone.end(), 1) == left.is_gone.end()) return surfaces;
  return WallParter(surfaces, walls).run(crossed, left);
}

}  // namespace

DiffusionSurfaces without_walls_in_grains(DiffusionSurfaces walls, const DiffusionSurfaces& grains,
                                          std::span<const int> spared, Threads threads) {
  if (walls.triangle.empty()) return walls;
  for (const std::vector<Core>& cores : sets_apart(cores_of(grains)))
    walls = without_walls_in(cores, std::move(walls), spared, threads);
  return walls;
}

}  // namespace pomona
