#include "generator/cut/carve/knife_face.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/carve/facet_normals.h"

namespace pomona {

namespace {

using Way = std::pair<std::uint32_t, std::uint32_t>;

/// Triangle by triangle of the knife.
class KnifeFaceBuilder {
 public:
  KnifeFaceBuilder(const Arrangement& all, const ClosedKnife& knife, const KnifeTraces& traces, const SplitMesh& mesh)
      : all_(all), knife_(knife), traces_(traces), mesh_(mesh) {
    face_.plane = knife.plane;
  }

  Face build() {
    for (std::size_t t = 0; t < knife_.mesh.triangle.size(); ++t) take(t);
    take_segments();
    for (const KnifeEdge& edge : traces_.edges) constrained_.insert(way_of(edge.from, edge.to));
    find_neighbors();
    return std::move(face_);
  }

 private:
  std::uint32_t vertex(std::uint32_t place) {
    const auto [entry, is_new] = vertex_of_.try_emplace(place, static_cast<std::uint32_t>(face_.point.size()));
    if (is_new) {
      face_.point.push_back(place);
      face_.place.push_back(mesh_.point[place]);
    }
    return entry->second;
  }

  void take(std::size_t number) {
    const Arrangement::Facet& facet = all_.facet[all_.fruit_count + number];
    const KnifeMesh::Triangle& whole = knife_.mesh.triangle[number];
    for (const PlaceTriangle& t : facet.mesh.triangle) {
      face_.triangle.emplace_back(vertex(t[0]), vertex(t[1]), vertex(t[2]));
      std::array<glm::vec3, 3> normal{};
      for (std::size_t i = 0; i < 3; ++i) normal[i] = normal_at(t[i], facet, whole.normal, mesh_.point);
      face_.normal.push_back(normal);
      face_.facet.push_back(whole.face);
    }
  }

  static Way way_of(std::uint32_t from, std::uint32_t to) { return std::minmax(from, to); }

  void take_segments() {
    face_.segment = traces_.segments;
    for (std::uint32_t s = 0; s < face_.segment.size(); ++s) {
      const CutSegment& segment = face_.segment[s];
      const auto from = vertex_of_.find(segment.from), to = vertex_of_.find(segment.to);
      if (from == vertex_of_.end() || to == vertex_of_.end()) continue;
      const auto [low, high] = std::minmax(from->second, to->second);
      face_.edges.push_back({low, high, s, from->second == low});
      constrained_.insert(way_of(segment.from, segment.to));
    }
    face_.sort_edges();
  }

  /// Two triangles at an edge are neighbours; of four, those that run it in opposite ways.
  void find_neighbors() {
    struct Side {
      std::uint32_t low = 0, high = 0;
      bool forward = false;
      std::uint32_t triangle = 0;
      std::size_t edge = 0;
    };

    // All sides of all triangles, with whether a surface or a crease follows them.
    std::vector<Side> sides;
    face_.neighbor.assign(face_.triangle.size(), {Face::none, Face::none, Face::none});
    face_.constrained.assign(face_.triangle.size(), {0, 0, 0});
    for (std::uint32_t t = 0; t < face_.triangle.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t p = face_.corner(t, i), q = face_.corner(t, i + 1);
        const auto [low, high] = std::minmax(p, q);
        sides.push_back({low, high, p == low, t, i});
        face_.constrained[t][i] = constrained_.contains(way_of(face_.point[p], face_.point[q])) ? 1 : 0;
      }
    }

    // Sides of one edge come to lie side by side, forward ones first, and are paired.
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::tie(a.low, a.high, a.forward, a.triangle) < std::tie(b.low, b.high, b.forward, b.triangle);
    });
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t middle = i, end = i;
      for (; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high; ++end) {
        middle += sides[end].forward ? 0 : 1;
      }
      for (std::size_t k = 0; i + k < middle && middle + k < end; ++k) {
        const Side &a = sides[i + k], &b = sides[middle + k];
        face_.neighbor[a.triangle][a.edge] = static_cast<std::int32_t>(b.triangle);
        face_.neighbor[b.triangle][b.edge] = static_cast<std::int32_t>(a.triangle);
      }
      i = end;
    }
  }

  const Arrangement& all_;
  const ClosedKnife& knife_;
  const KnifeTraces& traces_;
  const SplitMesh& mesh_;
  Face face_;
  std::unordered_map<std::uint32_t, std::uint32_t> vertex_of_;  // by place
  std::set<Way> constrained_;
};

}  // namespace

Face knife_face(const Arrangement& all, const ClosedKnife& knife, const KnifeTraces& traces, const SplitMesh& mesh) {
  return KnifeFaceBuilder(all, knife, traces, mesh).build();
}

}  // namespace pomona
