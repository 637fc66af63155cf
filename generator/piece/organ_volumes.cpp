#include "generator/piece/organ_volumes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/signed_volume.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// An edge of an organ's triangles, from the lower point to the higher one: so many more run this way than back.
struct OrganEdge {
  std::int32_t instance = 0;
  std::uint32_t low = 0, high = 0;
  int times = 0;

  bool is_at(const OrganEdge& other) const {
    return instance == other.instance && low == other.low && high == other.high;
  }
};

/// The mesh's triangles over welded points, measured from its first vertex so that sums keep their digits.
struct WeldedOrgans {
  const SolidMesh& mesh;
  std::vector<std::uint32_t> first;  // of all vertices at a place

  std::array<std::uint32_t, 3> points(std::size_t triangle) const {
    const glm::uvec3& v = mesh.triangle[triangle];
    return {first[v.x], first[v.y], first[v.z]};
  }
  glm::dvec3 at(std::uint32_t point) const {
    return glm::dvec3(mesh.position[point]) - glm::dvec3(mesh.position.front());
  }
};

/// Adds a triangle so many times; its area.
double add_triangle(OwnVolume& organ, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int times) {
  const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
  organ.volume += times * six_volumes(a, b, c) / 6;
  organ.area += area;
  return area;
}

/// What the organs' triangles enclose, before their holes are closed.
std::map<std::int32_t, OwnVolume> volumes_of_triangles(const WeldedOrgans& organs) {
  std::map<std::int32_t, OwnVolume> own;
  for (std::size_t t = 0; t < organs.mesh.triangle.size(); ++t) {
    if (organs.mesh.instance[t] == 0) continue;
    const auto [a, b, c] = organs.points(t);
    add_triangle(own[organs.mesh.instance[t]], organs.at(a), organs.at(b), organs.at(c), 1);
  }
  return own;
}

/// The edges at which an organ's triangles do not meet, by organ.
std::vector<OrganEdge> open_edges(const WeldedOrgans& organs) {
  std::vector<OrganEdge> edges;
  for (std::size_t t = 0; t < organs.mesh.triangle.size(); ++t) {
    const std::int32_t instance = organs.mesh.instance[t];
    if (instance == 0) continue;
    const std::array<std::uint32_t, 3> p = organs.points(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = p[k], to = p[(k + 1) % 3];
      if (from < to) edges.push_back({instance, from, to, 1});
      if (from > to) edges.push_back({instance, to, from, -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const OrganEdge& a, const OrganEdge& b) {
    return std::tie(a.instance, a.low, a.high) < std::tie(b.instance, b.low, b.high);
  });
  std::vector<OrganEdge> merged;
  for (const OrganEdge& edge : edges) {
    if (merged.empty() || !merged.back().is_at(edge))
      merged.push_back(edge);
    else
      merged.back().times += edge.times;
  }
  std::erase_if(merged, [](const OrganEdge& edge) { return edge.times == 0; });
  return merged;
}

/// Closes the holes of one organ, each by a fan around the middle of its rim.
void close_holes(OwnVolume& organ, std::span<const OrganEdge> edges, const WeldedOrgans& organs) {
  std::map<std::uint32_t, std::uint32_t> number;
  for (const OrganEdge& edge : edges)
    for (const std::uint32_t p : {edge.low, edge.high})
      number.try_emplace(p, static_cast<std::uint32_t>(number.size()));
  DisjointSets rims(number.size());
  for (const OrganEdge& edge : edges) rims.join(number[edge.low], number[edge.high]);

  struct Rim {
    glm::dvec3 sum{0};
    double length = 0;
  };
  std::vector<Rim> rim(number.size());
  for (const OrganEdge& edge : edges) {
    Rim& own = rim[rims.root(number[edge.low])];
    const double length = glm::distance(organs.at(edge.low), organs.at(edge.high));
    own.sum += 0.5 * length * (organs.at(edge.low) + organs.at(edge.high));
    own.length += length;
  }
  for (const OrganEdge& edge : edges) {
    const Rim& own = rim[rims.root(number[edge.low])];
    if (!(own.length > 0)) continue;
    const glm::dvec3 middle = own.sum / own.length;
    organ.open += add_triangle(organ, organs.at(edge.high), organs.at(edge.low), middle, edge.times);
  }
}

}  // namespace

std::map<std::int32_t, OwnVolume> organ_volumes(const SolidMesh& mesh) {
  const WeldedOrgans organs{mesh, weld(mesh.position)};
  std::map<std::int32_t, OwnVolume> own = volumes_of_triangles(organs);
  const std::vector<OrganEdge> edges = open_edges(organs);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].instance == edges[begin].instance) ++end;
    close_holes(own[edges[begin].instance], std::span(edges).subspan(begin, end - begin), organs);
  }
  return own;
}

}  // namespace pomona
