#include "generator/mesh/edges.h"

#include <algorithm>
#include <tuple>

namespace pomona {

namespace {

/// Counted, not compared: vertices are numbered without many gaps.
std::vector<HalfEdge> by_low_end(const std::vector<HalfEdge>& edges) {
  std::uint32_t last = 0;
  for (const HalfEdge& h : edges) last = std::max(last, h.low);
  std::vector<HalfEdge> sorted(edges);
  if (last > 64 * edges.size()) {
    std::stable_sort(sorted.begin(), sorted.end(), [](const HalfEdge& a, const HalfEdge& b) { return a.low < b.low; });
    return sorted;
  }
  std::vector<std::size_t> place(std::size_t{last} + 2, 0);
  for (const HalfEdge& h : edges) ++place[h.low + 1];
  for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
  for (const HalfEdge& h : edges) sorted[place[h.low]++] = h;
  return sorted;
}

/// Sorts the edges of one low end, which are few in most cases.
void sort_by_high_end(std::span<HalfEdge> edges) {
  constexpr std::size_t handful = 16;
  const auto is_before = [](const HalfEdge& a, const HalfEdge& b) { return a.high < b.high; };
  if (edges.size() > handful) return std::stable_sort(edges.begin(), edges.end(), is_before);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const HalfEdge moved = edges[i];
    std::size_t at = i;
    for (; at > 0 && moved.high < edges[at - 1].high; --at) edges[at] = edges[at - 1];
    edges[at] = moved;
  }
}

}  // namespace

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

  // They came by triangle and side, and each sort keeps that order among equals.
  sorted = by_low_end(sorted);
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    while (end < sorted.size() && sorted[end].low == sorted[first].low) ++end;
    sort_by_high_end({sorted.data() + first, end - first});
  }
  if (!options.kind.empty()) {
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const HalfEdge& a, const HalfEdge& b) { return a.kind < b.kind; });
  }
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
