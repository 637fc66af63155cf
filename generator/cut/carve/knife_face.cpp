#include "generator/cut/carve/knife_face.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/carve/facet_normals.h"
#include "generator/mesh/edge_map.h"
#include "generator/mesh/edges.h"

namespace pomona {

namespace {

/// Builds the face from the knife's triangles.
class KnifeFaceBuilder {
 public:
  KnifeFaceBuilder(const Arrangement& all, const ClosedKnife& knife, const KnifeTraces& traces, const SplitMesh& mesh)
      : all_(all), knife_(knife), traces_(traces), mesh_(mesh) {
    face_.plane = knife.plane;
  }

  Face build() {
    for (std::size_t t = 0; t < knife_.mesh.triangle.size(); ++t) take(t);
    take_segments();
    for (const KnifeEdge& edge : traces_.edges) constrained_.insert({edge.from, edge.to});
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

  void take_segments() {
    face_.segment = traces_.segments;
    for (std::uint32_t s = 0; s < face_.segment.size(); ++s) {
      const CutSegment& segment = face_.segment[s];
      const auto from = vertex_of_.find(segment.from), to = vertex_of_.find(segment.to);
      if (from == vertex_of_.end() || to == vertex_of_.end()) continue;
      const auto [low, high] = std::minmax(from->second, to->second);
      face_.edges.push_back({low, high, s, from->second == low});
      constrained_.insert({segment.from, segment.to});
    }
    face_.sort_edges();
  }

  /// Two triangles at an edge are neighbours; of four, those that use it in opposite directions.
  void find_neighbors() {
    // Mark the sides that a surface or a crease follows.
    face_.neighbor.assign(face_.triangle.size(), {Face::none, Face::none, Face::none});
    face_.constrained.assign(face_.triangle.size(), {0, 0, 0});
    for (std::uint32_t t = 0; t < face_.triangle.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeKey edge(face_.point[face_.corner(t, i)], face_.point[face_.corner(t, i + 1)]);
        face_.constrained[t][i] = constrained_.contains(edge) ? 1 : 0;
      }
    }

    // At each edge, pair sides in its direction with sides against it, in the order of the triangles.
    for_each_edge(sorted_half_edges(face_.triangle, {.of_collapsed = true}), [&](std::span<const HalfEdge> edge) {
      std::vector<HalfEdge> forward, back;
      for (const HalfEdge& side : edge) (side.forward ? forward : back).push_back(side);
      for (std::size_t k = 0; k < std::min(forward.size(), back.size()); ++k) {
        face_.neighbor[forward[k].triangle][forward[k].side] = static_cast<std::int32_t>(back[k].triangle);
        face_.neighbor[back[k].triangle][back[k].side] = static_cast<std::int32_t>(forward[k].triangle);
      }
    });
  }

  const Arrangement& all_;
  const ClosedKnife& knife_;
  const KnifeTraces& traces_;
  const SplitMesh& mesh_;
  Face face_;
  std::unordered_map<std::uint32_t, std::uint32_t> vertex_of_;  // by place
  EdgeSet constrained_;
};

}  // namespace

Face knife_face(const Arrangement& all, const ClosedKnife& knife, const KnifeTraces& traces, const SplitMesh& mesh) {
  return KnifeFaceBuilder(all, knife, traces, mesh).build();
}

}  // namespace pomona
