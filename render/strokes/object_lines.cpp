#include "render/strokes/object_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/mesh/edge_map.h"
#include "render/picture/chains.h"

namespace pomona {

namespace {

/// Links of one kind, to be chained together.
struct LineBundle {
  std::vector<LinePoint> nodes;
  std::vector<ChainLink> links;
};

/// Numbers keys in ascending order.
template <typename Key>
class Numbering {
 public:
  explicit Numbering(std::vector<Key> keys) : keys_(std::move(keys)) {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }
  std::uint32_t operator[](const Key& key) const {
    return static_cast<std::uint32_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
  }
  const std::vector<Key>& keys() const { return keys_; }

 private:
  std::vector<Key> keys_;
};

class ObjectLineFinder {
 public:
  ObjectLineFinder(const Solid& solid, const SolidEdges& edges, const SeenSolid& seen, const Lens& lens)
      : mesh_(solid.mesh), edges_(edges), seen_(seen), lens_(lens) {}

  LineBundle contours() const;
  LineBundle sharp(LineKind kind) const;

 private:
  bool front(std::uint32_t v) const { return seen_.facing[v] >= 0; }
  std::vector<std::pair<EdgeKey, EdgeKey>> contour_pieces() const;
  LinePoint point(const glm::dvec3& own, const glm::dvec3& away, const glm::dvec3& face) const;
  glm::dvec3 face_normal(std::uint32_t triangle) const;
  bool faces_eye(std::uint32_t triangle) const;
  LineKind drawn_as(const SharpEdge& edge) const;

  const SolidMesh& mesh_;
  const SolidEdges& edges_;
  const SeenSolid& seen_;
  const Lens& lens_;
};

/// `own` is in the fruit's frame; `away` and `face` are directions in the scene, of any length.
LinePoint ObjectLineFinder::point(const glm::dvec3& own, const glm::dvec3& away, const glm::dvec3& face) const {
  const glm::dvec3 at = seen_.turn * own + seen_.at;
  const glm::dvec3 sight = glm::normalize(lens_.eye() - at);
  const double size = glm::length(face);
  const double cosine = size > 0 ? std::fabs(glm::dot(face, sight)) / size : 0;
  const double slope = std::sqrt(std::max(1 - cosine * cosine, 0.0)) / std::max(cosine, 0.1);
  return {
      .seen = lens_.seen(at), .own = own, .outwards = lens_.seen_direction(at, away), .slope = std::min(slope, 8.0)};
}

glm::dvec3 ObjectLineFinder::face_normal(std::uint32_t triangle) const {
  const glm::dvec3 n = mesh_.area_vector(triangle);
  const double size = glm::length(n);
  return size > 0 ? seen_.turn * (n / size) : glm::dvec3(0);
}

bool ObjectLineFinder::faces_eye(std::uint32_t triangle) const {
  const glm::dvec3 at = seen_.in_scene(mesh_.position[mesh_.triangle[triangle].x]);
  return glm::dot(face_normal(triangle), lens_.eye() - at) >= 0;
}

/// For each triangle that the contour crosses, the two edges that it crosses, by their smooth vertices.
std::vector<std::pair<EdgeKey, EdgeKey>> ObjectLineFinder::contour_pieces() const {
  std::vector<std::pair<EdgeKey, EdgeKey>> pieces;
  for (std::size_t i = 0; i < mesh_.triangle.size(); ++i) {
    const glm::uvec3& t = mesh_.triangle[i];
    const auto& normal = mesh_.normal;
    if (mesh_.cut_face[i] >= 0 && normal[t.x] == normal[t.y] && normal[t.y] == normal[t.z]) continue;  // flat
    const std::array<bool, 3> turned{front(t.x), front(t.y), front(t.z)};
    if (turned[0] == turned[1] && turned[1] == turned[2]) continue;
    std::vector<EdgeKey> crossed;
    for (int k = 0; k < 3; ++k) {
      if (turned[k] == turned[(k + 1) % 3]) continue;
      crossed.emplace_back(edges_.smooth[t[k]], edges_.smooth[t[(k + 1) % 3]]);
    }
    if (crossed.size() == 2 && crossed[0] != crossed[1]) pieces.emplace_back(crossed[0], crossed[1]);
  }
  return pieces;
}

LineBundle ObjectLineFinder::contours() const {
  const auto pieces = contour_pieces();
  std::vector<EdgeKey> all;
  for (const auto& [a, b] : pieces) all.insert(all.end(), {a, b});
  const Numbering<EdgeKey> crossings(std::move(all));

  LineBundle bundle;
  for (const auto& [v, w] : crossings.keys()) {
    const double g = static_cast<double>(seen_.facing[v]), h = static_cast<double>(seen_.facing[w]);
    const double t = g != h ? std::clamp(g / (g - h), 0.0, 1.0) : 0.5;
    const glm::dvec3 p(mesh_.position[v]), q(mesh_.position[w]);
    const glm::dvec3 m(mesh_.normal[v]), n(mesh_.normal[w]);
    LinePoint on_contour = point(p + (q - p) * t, seen_.turn * (m + (n - m) * t), glm::dvec3(0));
    on_contour.slope = 0;
    bundle.nodes.push_back(on_contour);
  }
  for (const auto& [a, b] : pieces) bundle.links.push_back({crossings[a], crossings[b]});
  return bundle;
}

/// Sharp edges count as contours where one face is turned away.
LineKind ObjectLineFinder::drawn_as(const SharpEdge& edge) const {
  const bool is_skin = edge.kind == LineKind::crease || edge.kind == LineKind::seam;
  return is_skin && faces_eye(edge.first) != faces_eye(edge.other) ? LineKind::fold : edge.kind;
}

LineBundle ObjectLineFinder::sharp(LineKind kind) const {
  std::vector<const SharpEdge*> chosen;
  std::vector<std::uint32_t> places;
  for (const SharpEdge& edge : edges_.sharp) {
    if (drawn_as(edge) != kind) continue;
    const bool first = faces_eye(edge.first), other = faces_eye(edge.other);
    const bool shown = kind == LineKind::border || (kind == LineKind::fold ? first != other : first || other);
    if (!shown) continue;
    chosen.push_back(&edge);
    places.insert(places.end(), {edge.a, edge.b});
  }
  const Numbering<std::uint32_t> numbers(std::move(places));

  LineBundle bundle;
  bundle.nodes.resize(numbers.keys().size());
  for (const SharpEdge* edge : chosen) {
    // The flatter of the visible faces decides how far to look past the edge.
    const glm::dvec3 m = face_normal(edge->first), n = face_normal(edge->other);
    const glm::dvec3 away = kind == LineKind::inner ? glm::dvec3(0) : m + n;
    const glm::dvec3 face = faces_eye(edge->other) ? n : m;
    for (const std::uint32_t place : {edge->a, edge->b}) {
      LinePoint& node = bundle.nodes[numbers[place]];
      const double opacity = node.seen.z > 0 ? std::max(node.opacity, double{edge->opacity}) : double{edge->opacity};
      node = point(glm::dvec3(mesh_.position[place]), away, face);
      node.opacity = opacity;
    }
    bundle.links.push_back({numbers[edge->a], numbers[edge->b]});
  }
  return bundle;
}

void append(const LineBundle& bundle, LineKind kind, std::uint32_t instance, std::vector<ObjectLine>& lines) {
  std::vector<glm::dvec2> places;
  for (const LinePoint& node : bundle.nodes) places.emplace_back(node.seen);
  for (const Chain& chain : chained(bundle.links, places)) {
    ObjectLine line{.points = {}, .closed = chain.closed, .kind = kind, .instance = instance};
    for (const std::uint32_t node : nodes_of(chain, bundle.links)) line.points.push_back(bundle.nodes[node]);
    lines.push_back(std::move(line));
  }
}

}  // namespace

std::vector<ObjectLine> object_lines(const Solid& solid, const SolidEdges& edges, const SeenSolid& seen,
                                     std::uint32_t instance, const Lens& lens) {
  const ObjectLineFinder finder(solid, edges, seen, lens);
  std::vector<ObjectLine> lines;
  append(finder.contours(), LineKind::contour, instance, lines);
  for (const LineKind kind : {LineKind::border, LineKind::rim, LineKind::ridge, LineKind::crease, LineKind::seam,
                              LineKind::fold, LineKind::inner}) {
    append(finder.sharp(kind), kind, instance, lines);
  }
  return lines;
}

}  // namespace pomona
