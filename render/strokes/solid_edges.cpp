#include "render/strokes/solid_edges.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "render/picture/line_opacity.h"

namespace pomona {

namespace {

bool less(const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// One triangle's side, named by the places of its ends.
struct TriangleSide {
  std::uint64_t key = 0;
  std::uint32_t triangle = 0, side = 0;
  auto order() const { return std::tie(key, triangle, side); }
};

class EdgeFinder {
 public:
  explicit EdgeFinder(const Solid& solid) : solid_(solid) {}

  SolidEdges found() {
    weld();
    std::vector<TriangleSide> sides = sorted_sides();
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t j = i;
      while (j < sides.size() && sides[j].key == sides[i].key) ++j;
      look_at(std::span(sides).subspan(i, j - i));
      i = j;
    }
    return std::move(edges_);
  }

 private:
  void weld();
  std::vector<TriangleSide> sorted_sides() const;
  void look_at(std::span<const TriangleSide> sides);
  void look_at_pair(const TriangleSide& x, const TriangleSide& y);
  void add(const TriangleSide& x, const TriangleSide& y, LineKind kind, double opacity = 1);

  bool is_cut(const TriangleSide& s) const { return solid_.cut_face[s.triangle] >= 0; }
  /// The side's end that lies at the lower place, or the other one.
  std::uint32_t end(const TriangleSide& s, bool lower) const {
    const glm::uvec3& t = solid_.triangle[s.triangle];
    const std::uint32_t v = t[static_cast<int>(s.side)], w = t[static_cast<int>((s.side + 1) % 3)];
    return (edges_.place[v] < edges_.place[w]) == lower ? v : w;
  }
  glm::dvec3 face_normal(const TriangleSide& s) const {
    const glm::uvec3& t = solid_.triangle[s.triangle];
    const glm::dvec3 a(solid_.position[t.x]), b(solid_.position[t.y]), c(solid_.position[t.z]);
    return glm::cross(b - a, c - a);
  }

  const Solid& solid_;
  SolidEdges edges_;
};

void EdgeFinder::weld() {
  std::vector<std::uint32_t> order(solid_.position.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (solid_.position[a] != solid_.position[b]) return less(solid_.position[a], solid_.position[b]);
    if (solid_.normal[a] != solid_.normal[b]) return less(solid_.normal[a], solid_.normal[b]);
    return a < b;
  });
  edges_.place.resize(order.size());
  edges_.smooth.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t v = order[i], before = i > 0 ? order[i - 1] : v;
    const bool here = i > 0 && solid_.position[v] == solid_.position[before];
    edges_.place[v] = here ? edges_.place[before] : v;
    edges_.smooth[v] = here && solid_.normal[v] == solid_.normal[before] ? edges_.smooth[before] : v;
  }
}

std::vector<TriangleSide> EdgeFinder::sorted_sides() const {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * solid_.triangle.size());
  for (std::uint32_t t = 0; t < solid_.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const std::uint64_t a = edges_.place[solid_.triangle[t][i]], b = edges_.place[solid_.triangle[t][(i + 1) % 3]];
      if (a != b) sides.push_back({std::min(a, b) << 32 | std::max(a, b), t, static_cast<std::uint32_t>(i)});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const TriangleSide& x, const TriangleSide& y) { return x.order() < y.order(); });
  return sides;
}

void EdgeFinder::look_at(std::span<const TriangleSide> sides) {
  if (sides.size() == 1) return add(sides[0], sides[0], LineKind::border);
  if (sides.size() == 2) return look_at_pair(sides[0], sides[1]);

  // Bodies that share a cut, or touch: what tells most about them.
  const auto skin = std::find_if(sides.begin(), sides.end(), [&](const TriangleSide& s) { return !is_cut(s); });
  const auto cut = std::find_if(sides.begin(), sides.end(), [&](const TriangleSide& s) { return is_cut(s); });
  if (cut == sides.end()) return;
  if (skin != sides.end()) return add(*skin, *cut, LineKind::rim);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (solid_.cut_face[sides[i].triangle] != solid_.cut_face[sides[0].triangle]) {
      return add(sides[0], sides[i], LineKind::ridge);
    }
  }
}

void EdgeFinder::look_at_pair(const TriangleSide& x, const TriangleSide& y) {
  if (is_cut(x) != is_cut(y)) return add(x, y, LineKind::rim);
  const std::uint32_t xa = end(x, true), xb = end(x, false), ya = end(y, true), yb = end(y, false);
  if (is_cut(x)) {
    const bool smooth = edges_.smooth[xa] == edges_.smooth[ya] && edges_.smooth[xb] == edges_.smooth[yb];
    if (!smooth) return add(x, y, LineKind::ridge);
    const auto apart = [&](std::uint32_t v, std::uint32_t w) {
      if (solid_.color[v] == solid_.color[w]) return 0.0;
      return static_cast<double>(glm::distance(to_oklab(solid_.color[v]), to_oklab(solid_.color[w])));
    };
    const double opacity = line_opacity(0.5 * (apart(xa, ya) + apart(xb, yb)));
    if (opacity > 0) add(x, y, LineKind::inner, opacity);
    return;
  }

  if (solid_.surface[x.triangle] != solid_.surface[y.triangle]) return add(x, y, LineKind::seam);
  const glm::dvec3 m = face_normal(x), n = face_normal(y);
  const double mn = glm::dot(m, n), sharp = 0.25 * glm::dot(m, m) * glm::dot(n, n);
  if (mn < 0 || mn * mn < sharp) return add(x, y, LineKind::crease);
  const bool smooth = edges_.smooth[xa] == edges_.smooth[ya] && edges_.smooth[xb] == edges_.smooth[yb];
  if (!smooth) add(x, y, LineKind::fold);
}

void EdgeFinder::add(const TriangleSide& x, const TriangleSide& y, LineKind kind, double opacity) {
  edges_.sharp.push_back({edges_.place[end(x, true)], edges_.place[end(x, false)], x.triangle, y.triangle, kind,
                          static_cast<float>(opacity)});
}

}  // namespace

SolidEdges solid_edges(const Solid& solid) { return EdgeFinder(solid).found(); }

}  // namespace pomona
