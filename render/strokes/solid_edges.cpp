#include "render/strokes/solid_edges.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "render/picture/line_opacity.h"

namespace pomona {

namespace {

bool less(const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

class EdgeFinder {
 public:
  explicit EdgeFinder(const Solid& solid) : mesh_(solid.mesh) {}

  SolidEdges found() {
    weld();
    const std::vector<glm::uvec3> triangles = welded_triangles(edges_.place, mesh_.triangle);
    for_each_edge(sorted_half_edges(triangles, {.of_collapsed = true}),
                  [&](std::span<const HalfEdge> edge) { look_at(edge); });
    return std::move(edges_);
  }

 private:
  void weld();
  void look_at(std::span<const HalfEdge> sides);
  void look_at_pair(const HalfEdge& x, const HalfEdge& y);
  double sunk_opacity(std::span<const HalfEdge> sides) const;
  double color_jump(const HalfEdge& x, const HalfEdge& y) const;
  void add(const HalfEdge& x, const HalfEdge& y, LineKind kind, double opacity = 1);

  bool is_cut(const HalfEdge& h) const { return mesh_.cut_face[h.triangle] >= 0; }
  /// The solid's vertices at the lower and at the higher place.
  glm::uvec2 ends(const HalfEdge& h) const { return ends_in(mesh_.triangle, h); }

  const SolidMesh& mesh_;
  SolidEdges edges_;
};

/// Sorted by position and normal at once; of one position the vertex with the least normal stands for all.
void EdgeFinder::weld() {
  std::vector<std::uint32_t> order(mesh_.position.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (mesh_.position[a] != mesh_.position[b]) return less(mesh_.position[a], mesh_.position[b]);
    if (mesh_.normal[a] != mesh_.normal[b]) return less(mesh_.normal[a], mesh_.normal[b]);
    return a < b;
  });
  edges_.place.resize(order.size());
  edges_.smooth.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t v = order[i], before = i > 0 ? order[i - 1] : v;
    const bool here = i > 0 && mesh_.position[v] == mesh_.position[before];
    edges_.place[v] = here ? edges_.place[before] : v;
    edges_.smooth[v] = here && mesh_.normal[v] == mesh_.normal[before] ? edges_.smooth[before] : v;
  }
}

void EdgeFinder::look_at(std::span<const HalfEdge> sides) {
  if (sides.size() == 1) return add(sides[0], sides[0], LineKind::border);
  if (sides.size() == 2) return look_at_pair(sides[0], sides[1]);

  // Bodies share a cut, or touch: uses the most telling pair of triangles.
  const auto skin = std::find_if(sides.begin(), sides.end(), [&](const HalfEdge& h) { return !is_cut(h); });
  const auto cut = std::find_if(sides.begin(), sides.end(), [&](const HalfEdge& h) { return is_cut(h); });
  if (cut == sides.end()) return;
  const auto of_face = [&](const HalfEdge& h) { return mesh_.cut_face[h.triangle] == mesh_.cut_face[cut->triangle]; };
  const bool sunk = std::count_if(sides.begin(), sides.end(), of_face) >= 3;
  if (skin != sides.end()) return add(*skin, *cut, LineKind::rim, sunk ? sunk_opacity(sides) : 1);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (mesh_.cut_face[sides[i].triangle] != mesh_.cut_face[sides[0].triangle]) {
      return add(sides[0], sides[i], LineKind::ridge);
    }
  }
}

/// Where a body is sunk in another, as a stem's foot in the flesh, the other's face goes on across its outline. The rim
/// fades there to a line on a cut face, but not to nothing, because broken rims of thin roots flicker.
double EdgeFinder::sunk_opacity(std::span<const HalfEdge> sides) const {
  constexpr double min = 0.07, max = 0.75;
  double jump = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      if (is_cut(sides[i]) && is_cut(sides[k])) jump = std::max(jump, color_jump(sides[i], sides[k]));
    }
  }
  return min + (max - min) * line_opacity(jump);
}

/// The distance of the colours of two triangles at their common edge, in OKLab.
double EdgeFinder::color_jump(const HalfEdge& x, const HalfEdge& y) const {
  const auto apart = [&](std::uint32_t v, std::uint32_t w) {
    if (mesh_.color[v] == mesh_.color[w]) return 0.0;
    return static_cast<double>(glm::distance(to_oklab(mesh_.color[v]), to_oklab(mesh_.color[w])));
  };
  return 0.5 * (apart(ends(x).x, ends(y).x) + apart(ends(x).y, ends(y).y));
}

void EdgeFinder::look_at_pair(const HalfEdge& x, const HalfEdge& y) {
  if (is_cut(x) != is_cut(y)) return add(x, y, LineKind::rim);

  // Between two parts of a cut: a ridge where it bends, else an inner line where the colours change.
  const std::uint32_t xa = ends(x).x, xb = ends(x).y, ya = ends(y).x, yb = ends(y).y;
  if (is_cut(x)) {
    const bool smooth = edges_.smooth[xa] == edges_.smooth[ya] && edges_.smooth[xb] == edges_.smooth[yb];
    if (!smooth) return add(x, y, LineKind::ridge);
    const double opacity = line_opacity(color_jump(x, y));
    if (opacity > 0) add(x, y, LineKind::inner, opacity);
    return;
  }

  // Between two parts of the skin: a seam, a crease beyond 60 degrees, or a fold where normals part.
  if (mesh_.surface[x.triangle] != mesh_.surface[y.triangle]) return add(x, y, LineKind::seam);
  const glm::dvec3 m = mesh_.area_vector(x.triangle), n = mesh_.area_vector(y.triangle);
  const double mn = glm::dot(m, n), sharp = 0.25 * glm::dot(m, m) * glm::dot(n, n);
  if (mn < 0 || mn * mn < sharp) return add(x, y, LineKind::crease);
  const bool smooth = edges_.smooth[xa] == edges_.smooth[ya] && edges_.smooth[xb] == edges_.smooth[yb];
  if (!smooth) add(x, y, LineKind::fold);
}

void EdgeFinder::add(const HalfEdge& x, const HalfEdge& y, LineKind kind, double opacity) {
  edges_.sharp.push_back({x.low, x.high, x.triangle, y.triangle, kind, static_cast<float>(opacity)});
}

}  // namespace

SolidEdges solid_edges(const Solid& solid) { return EdgeFinder(solid).found(); }

}  // namespace pomona
