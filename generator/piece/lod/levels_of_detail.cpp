#include "generator/piece/lod/levels_of_detail.h"

#include <algorithm>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/mesh/signed_volume.h"
#include "generator/piece/lod/decimate.h"

namespace pomona {
namespace {

using Faces = std::vector<LevelFace>;

/// Half the triangles serve a picture of half the area, so errors grow by the root of two.
constexpr double level_growth = 1.4142135623730951;

constexpr std::uint32_t unset = 0xffffffffu;

void check(const LodOptions& options) {
  if (options.levels < 1 || options.levels > 6)
    throw Error(ExitStatus::usage, "levels of detail: " + std::to_string(options.levels), "1 to 6");
  if (!(options.error > 0) || !(options.color_error > 0))
    throw Error(ExitStatus::usage, "levels of detail: the errors must be above 0");
}

/// The diagonal of the bounding box, metres.
double size_of(const Solid& solid) {
  glm::vec3 low = solid.mesh.position.front(), high = low;
  for (const glm::vec3& p : solid.mesh.position) low = glm::min(low, p), high = glm::max(high, p);
  return glm::length(glm::dvec3(high) - glm::dvec3(low));
}

std::vector<LevelTarget> targets_of(const Solid& solid, std::size_t frozen, const LodOptions& options) {
  LevelBounds bounds{options.error * size_of(solid), options.color_error};
  std::vector<LevelTarget> targets;
  for (int level = 1; level <= options.levels; ++level) {
    const std::size_t wanted = solid.mesh.triangle.size() >> level;
    targets.push_back({wanted > frozen ? wanted - frozen : 0, bounds});
    bounds = {bounds.distance * level_growth, bounds.color * level_growth};
  }
  return targets;
}

double volume_of(const Solid& solid) {
  const std::vector<glm::vec3>& p = solid.mesh.position;
  return signed_volume(solid.mesh.triangle, [&](const glm::uvec3& t) -> std::array<glm::dvec3, 3> {
    return {p[t.x], p[t.y], p[t.z]};
  });
}

/// The solid with these triangles; vertices in the order in which triangles first use them.
Solid solid_of(const Solid& whole, const Solid& bare, const Faces& faces) {
  Solid level = bare;
  std::vector<std::uint32_t> number(whole.mesh.position.size(), unset);
  const auto vertex = [&](std::uint32_t v) {
    if (number[v] != unset) return number[v];
    level.mesh.position.push_back(whole.mesh.position[v]);
    level.mesh.normal.push_back(whole.mesh.normal[v]);
    level.mesh.color.push_back(whole.mesh.color[v]);
    level.mesh.part.push_back(whole.mesh.part[v]);
    if (!whole.mesh.guide.empty()) level.mesh.guide.push_back(whole.mesh.guide[v]);
    return number[v] = static_cast<std::uint32_t>(level.mesh.position.size() - 1);
  };
  for (const LevelFace& face : faces) {
    const std::uint32_t a = vertex(face.vertex.x), b = vertex(face.vertex.y), c = vertex(face.vertex.z);
    level.mesh.triangle.emplace_back(a, b, c);
    level.mesh.cut_face.push_back(whole.mesh.cut_face[face.source]);
    level.mesh.surface.push_back(whole.mesh.surface[face.source]);
    if (!whole.mesh.instance.empty()) level.mesh.instance.push_back(whole.mesh.instance[face.source]);
  }
  level.volume = volume_of(level);
  return level;
}

}  // namespace

std::vector<Solid> levels_of_detail(const Solid& solid, const LodOptions& options) {
  check(options);
  std::vector<Solid> levels;
  if (solid.mesh.triangle.empty()) return levels;

  // Frozen triangles stay in every level.
  const VertexFans fans = vertex_fans(solid);
  Faces frozen;
  for (const std::uint32_t t : fans.frozen) frozen.push_back({t, solid.mesh.triangle[t]});

  // Makes solids again, with triangles in their original order.
  Solid bare = solid;
  bare.mesh = {};
  bare.mesh.guide_lattice = solid.mesh.guide_lattice;
  std::size_t before = solid.mesh.triangle.size();
  for (Faces& faces : decimated(fans, solid.mesh, targets_of(solid, frozen.size(), options))) {
    faces.insert(faces.end(), frozen.begin(), frozen.end());
    std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.source < b.source; });
    if (faces.size() >= before) break;
    before = faces.size();
    levels.push_back(solid_of(solid, bare, faces));
    levels.back().name = solid.name + "_LOD" + std::to_string(levels.size());
  }
  return levels;
}

std::vector<std::vector<Solid>> all_levels_of_detail(std::span<const Solid> solids, const LodOptions& options) {
  check(options);
  std::vector<std::vector<Solid>> all(solids.size());
  parallel_for(solids.size(), options.threads, [&](std::size_t i) { all[i] = levels_of_detail(solids[i], options); });
  return all;
}

}  // namespace pomona
