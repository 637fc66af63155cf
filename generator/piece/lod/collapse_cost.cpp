#include "generator/piece/lod/collapse_cost.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pomona {
namespace {

/// The cost of an edge's length, added to squared distances: enough to prefer short edges where all else is equal, as
/// on a plane.
constexpr double cost_of_length = 1e-3;

/// Duplicates of a vertex share a colour quadric, except on borders.
std::vector<std::uint32_t> shared_tints(const LevelSource& source, const LevelMesh& level) {
  std::vector<std::uint8_t> at_border(source.position.size(), 0);
  for (std::uint32_t h = 0; h < level.mesh.twin.size(); ++h) {
    if (level.is_border(h)) at_border[level.mesh.from(h)] = at_border[level.mesh.to(h)] = 1;
  }
  std::vector<std::uint32_t> first(source.position.size(), none), tint(source.solid.position.size(), none);
  for (std::size_t f = 0; f < source.vertex.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t fan = source.mesh.corner[f][i], vertex = source.vertex[f][i];
      if (first[fan] == none) first[fan] = vertex;
      tint[vertex] = at_border[fan] != 0 ? vertex : first[fan];
    }
  }
  return tint;
}

/// The colours of a triangle. The gradient of a value that is 1 at a corner and 0 at the others is normal x opposite
/// edge / twice the area.
ColorQuadric tint_of_face(const LevelSource& source, std::size_t f, double metres_per_color) {
  const TriangleCorners c = source.corners(source.mesh.corner[f]);
  const double twice = glm::length(source.normal[f]);
  const glm::dvec3 normal = source.normal[f] / twice;
  std::array<glm::dvec3, 3> slope;
  for (std::size_t i = 0; i < 3; ++i) slope[i] = glm::cross(normal, c[(i + 2) % 3] - c[(i + 1) % 3]) / twice;
  ColorQuadric tint;
  tint.weight = twice / 6;
  for (int channel = 0; channel < 3; ++channel) {
    std::array<double, 3> value;
    for (std::size_t i = 0; i < 3; ++i) value[i] = metres_per_color * source.seen[source.vertex[f][i]][channel];
    const glm::dvec3 gradient = value[0] * slope[0] + value[1] * slope[1] + value[2] * slope[2];
    const double offset = value[0] - glm::dot(gradient, c[0]);
    tint.square += Quadric::of_plane(gradient, offset, tint.weight);
    tint.mean[static_cast<std::size_t>(channel)] = tint.weight * glm::dvec4(gradient, offset);
  }
  return tint;
}

}  // namespace

Quadric Quadric::of_plane(const glm::dvec3& n, double d, double w) {
  return {.xx = w * n.x * n.x,
          .xy = w * n.x * n.y,
          .xz = w * n.x * n.z,
          .yy = w * n.y * n.y,
          .yz = w * n.y * n.z,
          .zz = w * n.z * n.z,
          .x = w * n.x * d,
          .y = w * n.y * d,
          .z = w * n.z * d,
          .c = w * d * d};
}

Quadric& Quadric::operator+=(const Quadric& q) {
  xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
  x += q.x, y += q.y, z += q.z, c += q.c;
  return *this;
}

double Quadric::at(const glm::dvec3& p) const {
  return p.x * (xx * p.x + 2 * (xy * p.y + xz * p.z + x)) + p.y * (yy * p.y + 2 * (yz * p.z + y)) +
         p.z * (zz * p.z + 2 * z) + c;
}

ColorQuadric& ColorQuadric::operator+=(const ColorQuadric& q) {
  square += q.square;
  for (std::size_t i = 0; i < 3; ++i) mean[i] += q.mean[i];
  weight += q.weight;
  return *this;
}

double ColorQuadric::at(const glm::dvec3& p, const glm::dvec3& color) const {
  double sum = square.at(p);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4& m = mean[static_cast<std::size_t>(i)];
    sum += color[i] * (weight * color[i] - 2 * (m.x * p.x + m.y * p.y + m.z * p.z + m.w));
  }
  return sum;
}

CollapseCosts collapse_costs(const LevelSource& source, const LevelMesh& level, double metres_per_color) {
  CollapseCosts costs{.shape = std::vector<Quadric>(source.position.size()),
                      .shape_here = {},
                      .tint = std::vector<ColorQuadric>(source.solid.position.size()),
                      .tint_of = shared_tints(source, level),
                      .metres_per_color = metres_per_color};
  for (std::size_t f = 0; f < source.vertex.size(); ++f) {
    const double twice = glm::length(source.normal[f]);
    if (!(twice > 0)) continue;
    const glm::dvec3 normal = source.normal[f] / twice;
    const auto& fan = source.mesh.corner[f];
    const Quadric plane = Quadric::of_plane(normal, -glm::dot(normal, source.position[fan[0]]), twice / 6);
    const ColorQuadric tint = tint_of_face(source, f, metres_per_color);
    for (std::size_t i = 0; i < 3; ++i)
      costs.shape[fan[i]] += plane, costs.tint[costs.tint_of[source.vertex[f][i]]] += tint;
  }
  for (std::size_t f = 0; f < costs.shape.size(); ++f)
    costs.shape_here.push_back(std::max(costs.shape[f].at(source.position[f]), 0.0));
  return costs;
}

double cost_of(const CollapseCosts& costs, const LevelSource& source, const LevelMesh& level, std::uint32_t fan,
               const Spoke& spoke, bool on_border) {
  const glm::dvec3& p = source.position[spoke.fan];
  const auto tint_beside = [&](std::uint32_t face) {
    const std::uint32_t from = level.vertex_at(face, fan), to = level.vertex_at(face, spoke.fan);
    return std::max(costs.tint[costs.tint_of[from]].at(p, costs.metres_per_color * source.seen[to]), 0.0);
  };
  double sum = cost_of_length * source.area[fan] * squared(source.position[fan] - p);
  sum += std::max(costs.shape[fan].at(p), 0.0) + costs.shape_here[spoke.fan];
  sum += tint_beside(spoke.half_edge / 3);
  const std::uint32_t twin = level.mesh.twin[spoke.half_edge];
  return on_border && twin != none ? sum + tint_beside(twin / 3) : sum;
}

void take_over_shape(CollapseCosts& costs, const LevelSource& source, std::uint32_t from, std::uint32_t to) {
  costs.shape[to] += costs.shape[from];
  costs.shape_here[to] = std::max(costs.shape[to].at(source.position[to]), 0.0);
}

void take_over_tint(CollapseCosts& costs, std::uint32_t from, std::uint32_t to) {
  const std::uint32_t a = costs.tint_of[from], b = costs.tint_of[to];
  costs.tint[b] += ColorQuadric(costs.tint[a]);
}

}  // namespace pomona
