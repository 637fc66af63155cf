#include "render/picture/inner_lines.h"

#include <algorithm>
#include <array>
#include <tuple>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// A cut triangle's edge, its ends in an order that both its triangles agree on.
struct CutEdge {
  std::array<float, 6> ends{};
  int cut_face = 0;
  std::uint32_t triangle = 0;
  std::uint32_t a = 0, b = 0;
  auto key() const { return std::tie(ends, cut_face); }
};

std::vector<CutEdge> cut_edges(const Solid& solid) {
  std::vector<CutEdge> edges;
  for (std::uint32_t t = 0; t < solid.triangle.size(); ++t) {
    if (solid.cut_face[t] < 0) continue;
    for (int i = 0; i < 3; ++i) {
      std::uint32_t a = solid.triangle[t][i], b = solid.triangle[t][(i + 1) % 3];
      const auto place = [&](std::uint32_t v) {
        return std::tie(solid.position[v].x, solid.position[v].y, solid.position[v].z);
      };
      if (place(b) < place(a)) std::swap(a, b);
      const glm::vec3 &p = solid.position[a], &q = solid.position[b];
      edges.push_back({{p.x, p.y, p.z, q.x, q.y, q.z}, solid.cut_face[t], t, a, b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const CutEdge& x, const CutEdge& y) {
    return std::tuple(x.key(), x.triangle) < std::tuple(y.key(), y.triangle);
  });
  return edges;
}

}  // namespace

double line_opacity(double oklab_distance) {
  const double t = std::clamp((oklab_distance - 0.03) / (0.18 - 0.03), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

std::vector<InnerLine> inner_lines(const Solid& solid) {
  const std::vector<CutEdge> edges = cut_edges(solid);
  const auto apart = [&](std::uint32_t v, std::uint32_t w) {
    if (solid.color[v] == solid.color[w]) return 0.0f;
    return glm::distance(to_oklab(solid.color[v]), to_oklab(solid.color[w]));
  };
  std::vector<std::pair<std::uint32_t, InnerLine>> found;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const CutEdge &x = edges[i], &y = edges[i + 1];
    if (x.key() != y.key()) continue;
    const double opacity = line_opacity(0.5 * static_cast<double>(apart(x.a, y.a) + apart(x.b, y.b)));
    if (opacity == 0) continue;
    found.push_back({x.triangle, {solid.position[x.a], solid.position[x.b], static_cast<float>(opacity)}});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  std::vector<InnerLine> lines;
  for (const auto& [triangle, line] : found) lines.push_back(line);
  return lines;
}

}  // namespace pomona
