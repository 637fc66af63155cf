#include "generator/mesh/welded_edges.h"

#include <algorithm>

namespace pomona {

namespace {

/// A vertex as it is sorted; keys beside each other sort several times faster than keys looked up.
template <typename Vec>
struct Place {
  Vec position;
  std::uint32_t vertex;

  bool operator<(const Place& other) const {
    if (position.x != other.position.x) return position.x < other.position.x;
    if (position.y != other.position.y) return position.y < other.position.y;
    if (position.z != other.position.z) return position.z < other.position.z;
    return vertex < other.vertex;
  }
};

template <typename Vec>
std::vector<std::uint32_t> first_at_place(std::span<const Vec> positions) {
  std::vector<Place<Vec>> places;
  places.reserve(positions.size());
  for (const Vec& p : positions) places.push_back({p, static_cast<std::uint32_t>(places.size())});
  std::sort(places.begin(), places.end());

  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool same = i > 0 && places[i].position == places[i - 1].position;
    first[places[i].vertex] = same ? first[places[i - 1].vertex] : places[i].vertex;
  }
  return first;
}

}  // namespace

std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions) { return first_at_place(positions); }
std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions) { return first_at_place(positions); }

std::vector<glm::uvec3> welded_triangles(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
  const std::vector<std::uint32_t> first = weld(positions);
  std::vector<glm::uvec3> welded;
  welded.reserve(triangles.size());
  for (const glm::uvec3& t : triangles) welded.emplace_back(first[t.x], first[t.y], first[t.z]);
  return welded;
}

bool is_collapsed(const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

std::vector<WeldedEdge> sorted_edges(std::span<const glm::uvec3> welded_triangles) {
  std::vector<WeldedEdge> edges;
  edges.reserve(3 * welded_triangles.size());
  for (std::size_t i = 0; i < welded_triangles.size(); ++i) {
    const glm::uvec3& t = welded_triangles[i];
    if (is_collapsed(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(i), a < b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const WeldedEdge& l, const WeldedEdge& r) {
    if (l.low != r.low) return l.low < r.low;
    return l.high != r.high ? l.high < r.high : l.triangle < r.triangle;
  });
  return edges;
}

std::span<const WeldedEdge> equal_edges(std::span<const WeldedEdge> edges, std::size_t first) {
  std::size_t end = first;
  while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
  return edges.subspan(first, end - first);
}

}  // namespace pomona
