#include "generator/piece/lod/level_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

/// Normals more than 30 degrees apart make a border, so that edges stay edges in shading.
constexpr float crease_cosine = 0.866f;

/// Two colours at one place make a border if a channel differs by more than this, of the square root of light.
constexpr double min_jump = 0.012;

/// Level and solid are compared cut face by cut face and surface by surface; a place near another patch does not count
/// as near.
std::vector<std::uint32_t> patches_of(const SolidMesh& solid, const std::vector<std::uint32_t>& triangles) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t> number;
  std::vector<std::uint32_t> patch;
  for (const std::uint32_t t : triangles) {
    const auto next = static_cast<std::uint32_t>(number.size());
    patch.push_back(number.try_emplace({solid.cut_face[t], solid.surface[t]}, next).first->second);
  }
  return patch;
}

bool looks_alike(const LevelSource& source, std::uint32_t a, std::uint32_t b) {
  if (a == b) return true;
  const SolidMesh& solid = source.solid;
  return solid.part[a] == solid.part[b] && greatest(source.seen[a] - source.seen[b]) < min_jump &&
         glm::dot(solid.normal[a], solid.normal[b]) > crease_cosine;
}

bool is_border(const LevelSource& source, std::uint32_t h) {
  const std::uint32_t g = source.mesh.twin[h];
  if (g == none || source.patch[h / 3] != source.patch[g / 3]) return true;
  const auto vertex = [&](std::uint32_t half_edge) { return source.vertex[half_edge / 3][half_edge % 3]; };
  return !looks_alike(source, vertex(h), vertex(FanMesh::next(g))) ||
         !looks_alike(source, vertex(FanMesh::next(h)), vertex(g));
}

BorderChains chains_of(const LevelSource& source) {
  BorderChains chains;
  chains.of_edge.assign(source.mesh.twin.size(), none);
  for (std::uint32_t h = 0; h < chains.of_edge.size(); ++h) {
    const std::uint32_t g = source.mesh.twin[h];
    if ((g != none && g < h) || !is_border(source, h)) continue;
    chains.of_edge[h] = static_cast<std::uint32_t>(chains.first.size());
    if (g != none) chains.of_edge[g] = chains.of_edge[h];
    chains.first.push_back(none);
  }
  chains.last.assign(chains.first.size(), none);
  chains.next.assign(source.position.size(), none);
  chains.of_fan.assign(source.position.size(), none);
  return chains;
}

}  // namespace

LevelSource level_source(const VertexFans& fans, const SolidMesh& solid) {
  LevelSource source{.solid = solid,
                     .mesh = fan_mesh(fans),
                     .position = {},
                     .seen = {},
                     .area = {},
                     .vertex = {},
                     .normal = {},
                     .patch = patches_of(solid, fans.source)};
  for (const std::uint32_t vertex : fans.vertex) source.position.emplace_back(solid.position[vertex]);
  for (const Color& color : solid.color) source.seen.push_back(seen_color(glm::dvec3(color)));
  source.area.assign(fans.vertex.size(), 0.0);
  for (std::size_t f = 0; f < fans.triangle.size(); ++f) {
    const glm::uvec3& t = solid.triangle[fans.source[f]];
    source.vertex.push_back({t.x, t.y, t.z});
    source.normal.push_back(area_vector(source.corners(source.mesh.corner[f])));
    for (const std::uint32_t fan : source.mesh.corner[f]) source.area[fan] += glm::length(source.normal.back()) / 6;
  }
  return source;
}

LevelMesh level_mesh(const LevelSource& source) {
  LevelMesh level{.mesh = source.mesh,
                  .vertex = source.vertex,
                  .chains = chains_of(source),
                  .held = {},
                  .faces = source.vertex.size()};
  level.held.first.assign(level.faces, none);
  for (auto* ids : {&level.held.next, &level.held.face, &level.held.vertex})
    ids->assign(2 * source.position.size(), none);
  return level;
}

std::vector<LevelFace> faces_of(const LevelMesh& level, const VertexFans& fans) {
  std::vector<LevelFace> faces;
  for (std::size_t f = 0; f < level.vertex.size(); ++f) {
    const auto& v = level.vertex[f];
    if (level.mesh.is_there[f] != 0) faces.push_back({fans.source[f], {v[0], v[1], v[2]}});
  }
  return faces;
}

double squared_distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double length = squared(along);
  const double share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
  return squared(p - (a + along * share));
}

glm::dvec3 seen_color(const glm::dvec3& linear) { return glm::sqrt(glm::max(linear, glm::dvec3(0))); }

double greatest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace pomona
