#include "generator/surface/touching_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/surface/edge_leaves.h"

namespace pomona {

namespace {

/// So many triangles at one edge are no solids.
constexpr std::size_t crowd = 64;

/// True if solid, as the triangles face, lies twice at some angle around the edge, or less than not at all.
bool face_different_ways(const std::vector<EdgeLeaf>& leaves) {
  int now = 0, least = 0, most = 0;
  for (const EdgeLeaf& leaf : leaves) {
    now += leaf.forward ? -1 : 1;
    least = std::min(least, now);
    most = std::max(most, now);
  }
  return now != 0 || most - least > 1;
}

/// True if two triangles at one place face the same way: solids that share a face would face it against each other.
bool some_face_alike(const std::vector<EdgeLeaf>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const EdgeLeaf &a = leaves[i], &b = leaves[(i + 1) % leaves.size()];
    if (a.forward == b.forward && at_one_angle(a, b)) return true;
  }
  return false;
}

/// The number of each triangle's part.
std::vector<std::uint32_t> parts_by_edges(const EdgedMesh& mesh) {
  DisjointSets sets(mesh.triangles.size());
  for_each_edge(mesh.half_edges, [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& h : edge) sets.join(edge.front().triangle, h.triangle);
  });
  std::vector<std::uint32_t> part(mesh.triangles.size());
  for (std::uint32_t t = 0; t < part.size(); ++t) part[t] = sets.root(t);
  return part;
}

/// What the edges tell, per part.
struct EdgeSigns {
  std::vector<std::uint8_t> differ;  ///< solids at some edge face different ways
  std::vector<std::uint8_t> alike;   ///< two triangles at one place face alike
};

EdgeSigns signs_at_edges(const EdgedMesh& mesh, const std::vector<std::uint32_t>& part_of) {
  const std::size_t count = mesh.triangles.size();
  EdgeSigns signs{std::vector<std::uint8_t>(count, 0), std::vector<std::uint8_t>(count, 0)};
  std::vector<std::uint8_t> unclear(count, 0);
  for_each_edge(mesh.half_edges, [&](std::span<const HalfEdge> edge) {
    const std::uint32_t part = part_of[edge.front().triangle];
    if (edge.size() % 2 != 0 || edge.size() > crowd) unclear[part] = 1;
    if (edge.size() <= 2 || unclear[part] != 0 || signs.alike[part] != 0) return;
    const std::vector<EdgeLeaf> leaves = leaves_around(edge, mesh.triangles, mesh.surfaces.position);
    if (some_face_alike(leaves)) signs.alike[part] = 1;
    if (face_different_ways(leaves)) signs.differ[part] = 1;
  });
  for (std::size_t i = 0; i < count; ++i)
    if (unclear[i] != 0) signs.differ[i] = 0;
  return signs;
}

Enclosures space_of_wrong(const EdgedMesh& mesh, const std::vector<std::uint32_t>& part_of,
                          const std::vector<std::uint8_t>& is_wrong) {
  std::vector<Enclosures::Triangle> walls;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (is_wrong[part_of[t]] == 0 || is_collapsed(mesh.triangles[t])) continue;
    walls.push_back({.corner = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, .mesh = part_of[t]});
  }
  return Enclosures(std::move(walls));
}

/// Per part: it winds around some place beside it less often than not at all.
std::vector<std::uint8_t> parts_below_nothing(const EdgedMesh& mesh, const TouchingParts& parts,
                                              const std::vector<std::uint8_t>& settled) {
  std::vector<std::uint8_t> negative(mesh.triangles.size(), 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t part = parts.of_triangle[t];
    if (!parts.holds_wrong(t) || settled[part] != 0 || negative[part] != 0) continue;
    const auto windings = windings_beside(mesh, parts, t);
    if (windings && std::min((*windings)[0], (*windings)[1]) < 0) negative[part] = 1;
  }
  return negative;
}

}  // namespace

bool TouchingParts::any_wrong() const {
  return std::any_of(is_wrong.begin(), is_wrong.end(), [](std::uint8_t wrong) { return wrong != 0; });
}

TouchingParts touching_parts(const EdgedMesh& mesh) {
  std::vector<std::uint32_t> part_of = parts_by_edges(mesh);
  EdgeSigns signs = signs_at_edges(mesh, part_of);
  Enclosures space = space_of_wrong(mesh, part_of, signs.differ);
  TouchingParts parts{std::move(part_of), std::move(signs.differ), std::move(space)};
  // Solids that face outwards and cross each other are no fault: nowhere is less than nothing.
  const std::vector<std::uint8_t> negative = parts_below_nothing(mesh, parts, signs.alike);
  for (std::size_t i = 0; i < parts.is_wrong.size(); ++i)
    if (signs.alike[i] == 0 && negative[i] == 0) parts.is_wrong[i] = 0;
  return parts;
}

std::optional<std::array<int, 2>> windings_beside(const EdgedMesh& mesh, const TouchingParts& parts,
                                                  std::uint32_t triangle) {
  const glm::dvec3 a = mesh.corner(triangle, 0), b = mesh.corner(triangle, 1), c = mesh.corner(triangle, 2);
  const glm::dvec3 area = glm::cross(b - a, c - a);
  const double twice = glm::length(area);
  if (!(twice > 0)) return std::nullopt;
  constexpr double depth = 1e-4;  // as a share of the triangle's size
  const glm::dvec3 step = depth * area / std::sqrt(twice);
  const auto winding = [&](const glm::dvec3& place) {
    for (const auto& [part, times] : parts.space.around(place))
      if (part == parts.of_triangle[triangle]) return times;
    return 0;
  };
  const glm::dvec3 middle = (a + b + c) / 3.0;
  return std::array{winding(middle + step), winding(middle - step)};
}

}  // namespace pomona
