#include "render/style/face_relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

constexpr double clear_depth = 0.0034;  // metres; a part that lets light in deeper is a gel (shaders/lit.glsl)

std::uint64_t cell_key(const glm::i64vec3& cell) {
  constexpr std::uint64_t mask = (1u << 21) - 1;
  const auto bits = [](std::int64_t v) { return static_cast<std::uint64_t>(v) & mask; };
  return (bits(cell.x) << 42) | (bits(cell.y) << 21) | bits(cell.z);
}

glm::i64vec3 rim_cell(const glm::dvec3& p) { return {glm::floor(p / FaceRelief::reach)}; }

/// The height as a share of the relief, and its slope per distance of 2 |relief|.
struct ReliefProfile {
  double share = 1, growth = 0;
};
ReliefProfile profile(double distance, double way) {
  const double left = 1 - distance / way;
  return left > 0 ? ReliefProfile{1 - left * left, 2 * left} : ReliefProfile{};
}

}  // namespace

bool shows_rim(const MaterialSketch& material) {
  return material.relief != 0 || material.translucency.depth > clear_depth;
}

FaceRelief::FaceRelief(const Solid& solid) : solid_(solid), group_of_(solid.mesh.triangle.size(), -1) {
  group_triangles();
  if (!groups_.empty()) find_borders();
}

/// Makes a group for each part on each face, of parts with a relief or gel.
void FaceRelief::group_triangles() {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> known;
  for (std::size_t t = 0; t < solid_.mesh.triangle.size(); ++t) {
    if (solid_.mesh.cut_face[t] < 0) continue;
    const std::int32_t part = solid_.mesh.part[solid_.mesh.triangle[t].x];
    const auto [entry, is_new] = known.try_emplace({solid_.mesh.cut_face[t], part}, -1);
    if (is_new) {
      const MaterialSketch material = material_of(solid_, part);
      if (shows_rim(material)) {
        entry->second = static_cast<std::int32_t>(groups_.size());
        groups_.push_back({.cells = {}, .relief = material.relief});
      }
    }
    group_of_[t] = entry->second;
  }
}

/// Edges of a group's triangles that no other triangle of the group has.
void FaceRelief::find_borders() {
  const std::vector<glm::uvec3> triangles = welded_triangles(weld(solid_.mesh.position), solid_.mesh.triangle);
  const HalfEdgeOptions by_group{.kind = group_of_, .of_collapsed = true};
  for_each_edge(sorted_half_edges(triangles, by_group), [&](std::span<const HalfEdge> edge) {
    const HalfEdge& side = edge.front();
    if (edge.size() > 1 || side.kind < 0) return;
    const std::array<glm::dvec3, 3> p = solid_.mesh.corners(side.triangle);
    const glm::dvec3 &a = p[side.side], &b = p[(side.side + 1u) % 3], &c = p[(side.side + 2u) % 3];
    const glm::dvec3 along = b - a;
    const double squared = glm::dot(along, along);
    if (squared == 0) return;
    const glm::dvec3 across = c - a - along * (glm::dot(c - a, along) / squared);
    const double width = std::sqrt(glm::dot(across, across));
    if (width > 0) add(groups_[static_cast<std::size_t>(side.kind)], {a, b, across / width});
  });
}

void FaceRelief::add(Group& group, const Segment& segment) {
  // Enters the edge into every cell that is within reach of it.
  const glm::i64vec3 low = rim_cell(glm::min(segment.from, segment.to) - reach);
  const glm::i64vec3 high = rim_cell(glm::max(segment.from, segment.to) + reach);
  const auto index = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back(segment);
  for (std::int64_t x = low.x; x <= high.x; ++x) {
    for (std::int64_t y = low.y; y <= high.y; ++y) {
      for (std::int64_t z = low.z; z <= high.z; ++z) group.cells[cell_key({x, y, z})].push_back(index);
    }
  }
}

RimPlace FaceRelief::at(std::uint32_t triangle, const glm::dvec3& place) const {
  if (group_of_[triangle] < 0) return {};
  const Group& group = groups_[static_cast<std::size_t>(group_of_[triangle])];
  const auto cell = group.cells.find(cell_key(rim_cell(place)));
  RimPlace found{.height = group.relief};
  if (cell == group.cells.end()) return found;

  // The nearest edge; at a corner the mean of both edges' inward directions.
  constexpr double alike = 1e-9;  // metres
  double min = reach;
  glm::dvec3 inwards(0);
  for (const std::uint32_t i : cell->second) {
    const Segment& s = segments_[i];
    const glm::dvec3 along = s.to - s.from;
    const double share = std::clamp(glm::dot(place - s.from, along) / glm::dot(along, along), 0.0, 1.0);
    const glm::dvec3 away = place - s.from - along * share;
    const double distance = std::sqrt(glm::dot(away, away));
    if (distance > min + alike) continue;
    const glm::dvec3 way = distance > alike ? away / distance : s.inwards;
    inwards = distance < min - alike ? way : inwards + way;
    min = std::min(min, distance);
  }
  found.rim = min;
  if (group.relief == 0) return found;
  const double way = 2 * std::fabs(group.relief), length = std::sqrt(glm::dot(inwards, inwards));
  const ReliefProfile at_distance = profile(min, way);
  found.height = group.relief * at_distance.share;
  if (length > 0) found.slope = inwards * (group.relief * at_distance.growth / way / length);
  return found;
}

std::vector<RimPlace> FaceRelief::at_vertices() const {
  std::vector<RimPlace> places(solid_.mesh.position.size());
  if (empty()) return places;
  // Just within each triangle, so that a corner on the border knows its inward direction.
  std::vector<int> count(places.size(), 0);
  constexpr double within = 0.02;
  for (std::uint32_t t = 0; t < solid_.mesh.triangle.size(); ++t) {
    if (group_of_[t] < 0) continue;
    const glm::uvec3& v = solid_.mesh.triangle[t];
    const std::array<glm::dvec3, 3> p = solid_.mesh.corners(t);
    const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const RimPlace here = at(t, p[k] + (middle - p[k]) * within);
      const std::uint32_t vertex = v[static_cast<glm::length_t>(k)];
      RimPlace& sum = places[vertex];
      if (count[vertex]++ == 0) sum = {.rim = 0, .height = 0};
      sum.rim += here.rim, sum.height += here.height, sum.slope += here.slope;
    }
  }
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (count[v] == 0) continue;
    const double share = 1.0 / count[v];
    places[v] = {places[v].rim * share, places[v].height * share, places[v].slope * share};
  }
  return places;
}

}  // namespace pomona
