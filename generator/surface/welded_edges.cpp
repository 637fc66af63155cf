#include "generator/surface/welded_edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pomona {

std::vector<std::uint32_t> weld(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t v) { return std::tuple(positions[v].x, positions[v].y, positions[v].z); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
    const auto a = key(l), b = key(r);
    return a != b ? a < b : l < r;
  });

  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

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
    return std::tie(l.low, l.high, l.triangle) < std::tie(r.low, r.high, r.triangle);
  });
  return edges;
}

std::span<const WeldedEdge> equal_edges(std::span<const WeldedEdge> edges, std::size_t first) {
  std::size_t end = first;
  while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
  return edges.subspan(first, end - first);
}

}  // namespace pomona
