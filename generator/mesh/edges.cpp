#include "generator/mesh/edges.h"

#include <algorithm>
#include <tuple>

namespace pomona {

std::vector<HalfEdge> sorted_half_edges(std::span<const glm::uvec3> triangles, const HalfEdgeOptions& options) {
  std::vector<HalfEdge> sorted;
  sorted.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::uvec3& t = triangles[i];
    if (!options.of_collapsed && is_collapsed(t)) continue;
    const std::int32_t kind = options.kind.empty() ? 0 : options.kind[i];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a == b) continue;
      sorted.push_back(
          {kind, std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(k), a < b});
    }
  }
  const auto order = [](const HalfEdge& h) { return std::tie(h.kind, h.low, h.high, h.triangle, h.side); };
  std::sort(sorted.begin(), sorted.end(), [&](const HalfEdge& a, const HalfEdge& b) { return order(a) < order(b); });
  return sorted;
}

std::span<const HalfEdge> edge_at(std::span<const HalfEdge> sorted, std::size_t first) {
  const auto edge = [&](std::size_t i) { return std::tie(sorted[i].kind, sorted[i].low, sorted[i].high); };
  std::size_t end = first;
  while (end < sorted.size() && edge(end) == edge(first)) ++end;
  return sorted.subspan(first, end - first);
}

int balance(std::span<const HalfEdge> edge) {
  int sum = 0;
  for (const HalfEdge& h : edge) sum += h.forward ? 1 : -1;
  return sum;
}

bool is_closed(std::span<const glm::uvec3> triangles) {
  bool closed = true;
  for_each_edge(sorted_half_edges(triangles),
                [&](std::span<const HalfEdge> edge) { closed = closed && balance(edge) == 0; });
  return closed;
}

glm::uvec2 ends_in(std::span<const glm::uvec3> triangles, const HalfEdge& h) {
  const glm::uvec3& t = triangles[h.triangle];
  const std::uint32_t from = t[h.side], to = t[(h.side + 1) % 3];
  return h.forward ? glm::uvec2(from, to) : glm::uvec2(to, from);
}

bool is_collapsed(const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

}  // namespace pomona
