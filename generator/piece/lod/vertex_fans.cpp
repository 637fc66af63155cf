#include "generator/piece/lod/vertex_fans.h"

#include <cstddef>
#include <span>

#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {
namespace {

constexpr std::uint32_t unset = 0xffffffffu;

/// True if an edge has at most one triangle for either direction.
bool is_manifold(std::span<const HalfEdge> edge) {
  return edge.size() < 2 || (edge.size() == 2 && edge[0].forward != edge[1].forward);
}

class FanBuilder {
 public:
  explicit FanBuilder(const Solid& solid)
      : place_(welded_triangles(weld(solid.mesh.position), solid.mesh.triangle)),
        edges_(sorted_half_edges(place_)),
        is_frozen_(place_.size(), 0),
        corners_(3 * place_.size()),
        fans_at_(solid.mesh.position.size(), 0),
        is_fixed_(solid.mesh.position.size(), 0) {}

  VertexFans build() {
    freeze();
    join_corners();
    number_fans();
    pair_edges();
    lock();
    return std::move(fans_);
  }

 private:
  /// Triangles at an edge that a half-edge structure cannot hold stay as they are, and so do their corners.
  void freeze() {
    for_each_edge(edges_, [&](std::span<const HalfEdge> edge) {
      for (const HalfEdge& side : edge) {
        if (!is_manifold(edge)) is_frozen_[side.triangle] = 1;
      }
    });
    for (std::uint32_t t = 0; t < place_.size(); ++t) {
      if (is_frozen_[t] == 0) continue;
      fans_.frozen.push_back(t);
      for (int i = 0; i < 3; ++i) is_fixed_[place_[t][i]] = 1;
    }
  }

  std::uint32_t corner_at(std::uint32_t triangle, std::uint32_t place) const {
    const glm::uvec3& t = place_[triangle];
    return 3 * triangle + (t.x == place ? 0u : t.y == place ? 1u : 2u);
  }

  bool is_paired(std::span<const HalfEdge> edge) const {
    return edge.size() == 2 && is_frozen_[edge[0].triangle] == 0 && is_frozen_[edge[1].triangle] == 0;
  }

  void join_corners() {
    for_each_edge(edges_, [&](std::span<const HalfEdge> edge) {
      if (!is_paired(edge)) return;
      for (const std::uint32_t place : {edge[0].low, edge[0].high})
        corners_.join(corner_at(edge[0].triangle, place), corner_at(edge[1].triangle, place));
    });
  }

  /// Numbers fans in the order in which triangles first use them.
  void number_fans() {
    std::vector<std::uint32_t> number(corners_.count(), unset);
    for (std::uint32_t t = 0; t < place_.size(); ++t) {
      if (is_frozen_[t] != 0 || is_collapsed(place_[t])) continue;
      glm::uvec3 triangle(0);
      for (std::uint32_t i = 0; i < 3; ++i) {
        std::uint32_t& fan = number[corners_.root(3 * t + i)];
        if (fan == unset) {
          fan = static_cast<std::uint32_t>(fans_.vertex.size());
          fans_.vertex.push_back(place_[t][static_cast<int>(i)]);
          ++fans_at_[place_[t][static_cast<int>(i)]];
        }
        triangle[static_cast<int>(i)] = fan;
      }
      fans_.triangle.push_back(triangle);
      fans_.source.push_back(t);
    }
  }

  void pair_edges() {
    std::vector<std::uint32_t> number(place_.size(), unset);  // of those that are not frozen
    for (std::uint32_t f = 0; f < fans_.source.size(); ++f) number[fans_.source[f]] = f;
    fans_.twin.assign(3 * fans_.source.size(), unset);
    for_each_edge(edges_, [&](std::span<const HalfEdge> edge) {
      if (!is_paired(edge)) return;
      const std::uint32_t a = 3 * number[edge[0].triangle] + edge[0].side;
      const std::uint32_t b = 3 * number[edge[1].triangle] + edge[1].side;
      fans_.twin[a] = b, fans_.twin[b] = a;
    });
  }

  void lock() {
    for (const std::uint32_t place : fans_.vertex)
      fans_.is_locked.push_back(is_fixed_[place] != 0 || fans_at_[place] > 1 ? 1 : 0);
  }

  std::vector<glm::uvec3> place_;
  std::vector<HalfEdge> edges_;
  std::vector<std::uint8_t> is_frozen_;  // per triangle
  DisjointSets corners_;
  std::vector<std::uint32_t> fans_at_;  // per place: how many fans
  std::vector<std::uint8_t> is_fixed_;  // per place: it is a corner of a frozen triangle
  VertexFans fans_;
};

}  // namespace

VertexFans vertex_fans(const Solid& solid) { return FanBuilder(solid).build(); }

}  // namespace pomona
