#include "generator/cut/carve/labels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "generator/mesh/crossings/tie_rule.h"
#include "generator/mesh/edge_map.h"

namespace pomona {

namespace {

constexpr int unknown = std::numeric_limits<int>::min();

/// What runs along the edges of one facet's parts.
struct FacetEdges {
  EdgeMap<int> balance;           // segments from the lower place to the higher less those that go back
  EdgeMap<std::uint32_t> border;  // the facet's own edge that this is a part of

  int along(std::uint32_t from, std::uint32_t to) const {
    const int* found = balance.find({from, to});
    if (!found) return 0;
    return from < to ? *found : -*found;
  }
};

FacetEdges edges_of(const Arrangement::Facet& facet) {
  FacetEdges edges;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<std::uint32_t>& chain = facet.mesh.chain[i];
    for (std::size_t k = 1; k < chain.size(); ++k) edges.border[{chain[k - 1], chain[k]}] = facet.edge[i];
  }
  for (std::size_t i = 3; i < facet.mesh.chain.size(); ++i) {
    const std::vector<std::uint32_t>& chain = facet.mesh.chain[i];
    for (std::size_t k = 1; k < chain.size(); ++k)
      edges.balance[{chain[k - 1], chain[k]}] += chain[k - 1] < chain[k] ? 1 : -1;
  }
  return edges;
}

/// Goes from part to part, and from triangle to triangle across common edges. An edge lies as deep in the knife as the
/// part on either side of it, but for the segments that follow it there: left of a segment it is deeper by one.
class Labeller {
 public:
  Labeller(const Arrangement& all, const ExactPoints& places) : all_(all), places_(places) {}

  std::vector<std::vector<int>> run() {
    first_part_.push_back(0);
    for (std::size_t f = 0; f < all_.fruit_count; ++f) {
      first_part_.push_back(first_part_.back() + static_cast<std::uint32_t>(all_.facet[f].mesh.triangle.size()));
    }
    for (std::size_t f = 0; f < all_.fruit_count; ++f) take(f);
    join_across_edges();
    sort_steps();
    label_.assign(first_part_.back(), unknown);
    for (std::size_t f = 0; f < all_.fruit_count; ++f) {
      if (!all_.facet[f].mesh.triangle.empty() && label_[first_part_[f]] == unknown) start(f);
    }
    std::vector<std::vector<int>> of_facet(all_.fruit_count);
    for (std::size_t f = 0; f < all_.fruit_count; ++f) {
      of_facet[f].assign(label_.begin() + first_part_[f], label_.begin() + first_part_[f + 1]);
    }
    return of_facet;
  }

 private:
  struct Step {
    std::uint32_t from = 0, to = 0;  // parts
    int change = 0;                  // of the label
  };
  /// A part's edge that lies on its facet's border.
  struct Border {
    std::uint32_t edge = 0;  // the facet's, of which `between` is a part
    EdgeKey between;
    std::uint32_t part = 0;
    int across = 0;  // change of the label from the part to the edge
    auto key() const { return std::tie(edge, between); }
  };

  void take(std::size_t number) {
    const Arrangement::Facet& facet = all_.facet[number];
    if (facet.is_whole()) {
      for (std::size_t i = 0; i < 3; ++i)
        borders_.push_back({facet.edge[i], {facet.corner[i], facet.corner[(i + 1) % 3]}, first_part_[number], 0});
      return;
    }
    const FacetEdges edges = edges_of(facet);
    EdgeMap<std::uint32_t> other;  // part on the other side of an inner edge
    for (std::uint32_t k = 0; k < facet.mesh.triangle.size(); ++k) {
      const PlaceTriangle& t = facet.mesh.triangle[k];
      const std::uint32_t part = first_part_[number] + k;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = t[i], to = t[(i + 1) % 3];
        const EdgeKey edge(from, to);
        const int across = -edges.along(from, to);
        if (const std::uint32_t* border = edges.border.find(edge)) {
          borders_.push_back({*border, edge, part, across});
          continue;
        }
        const auto [beyond, is_new] = other.try_emplace(edge, part);
        if (is_new) continue;
        steps_.push_back({part, beyond, across});
        steps_.push_back({beyond, part, -across});
      }
    }
  }

  void join_across_edges() {
    std::sort(borders_.begin(), borders_.end(), [](const Border& a, const Border& b) {
      return std::tuple(a.key(), a.part) < std::tuple(b.key(), b.part);
    });
    for (std::size_t i = 0, end; i < borders_.size(); i = end) {
      for (end = i + 1; end < borders_.size() && borders_[end].key() == borders_[i].key(); ++end) {
        const int change = borders_[i].across - borders_[end].across;
        steps_.push_back({borders_[i].part, borders_[end].part, change});
        steps_.push_back({borders_[end].part, borders_[i].part, -change});
      }
    }
  }

  void sort_steps() {
    std::stable_sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) { return a.from < b.from; });
    first_step_.assign(first_part_.back() + 1, 0);
    for (const Step& s : steps_) ++first_step_[s.from + 1];
    for (std::size_t i = 1; i < first_step_.size(); ++i) first_step_[i] += first_step_[i - 1];
  }

  /// Finds how deep the facet's first corner lies, and goes on from the part that has the beginning of its first edge.
  void start(std::size_t number) {
    // Find how deep the first corner lies, after a vanishing step along the first edge.
    const Arrangement::Facet& facet = all_.facet[number];
    const std::uint32_t corner = facet.corner[0];
    std::uint32_t part = first_part_[number];
    int depth = winding_at(corner) + crossings_at(corner, all_.edge[facet.edge[0]]);

    // Find the part of the facet with the beginning of that edge, and what lies along it.
    if (!facet.is_whole()) {
      const std::uint32_t end = facet.mesh.chain[0][1];
      for (std::uint32_t k = 0; k < facet.mesh.triangle.size(); ++k) {
        const PlaceTriangle& t = facet.mesh.triangle[k];
        for (std::size_t i = 0; i < 3; ++i) {
          if (t[i] == corner && t[(i + 1) % 3] == end) part = first_part_[number] + k;
        }
      }
      depth += edges_of(facet).along(corner, end);
    }

    // Walk over all connected parts.
    label_[part] = depth;
    std::vector<std::uint32_t> stack{part};
    while (!stack.empty()) {
      const std::uint32_t from = stack.back();
      stack.pop_back();
      for (std::uint32_t s = first_step_[from]; s < first_step_[from + 1]; ++s) {
        if (label_[steps_[s].to] != unknown) continue;
        label_[steps_[s].to] = label_[from] + steps_[s].change;
        stack.push_back(steps_[s].to);
      }
    }
  }

  int winding_at(std::uint32_t place) const {
    int sum = 0;
    for (std::size_t f = all_.fruit_count; f < all_.facet.size(); ++f) {
      const PlaceTriangle& t = all_.facet[f].corner;
      sum += winding_of_knife({places_.at(t[0]), places_.at(t[1]), places_.at(t[2])}, places_.at(place));
    }
    return sum;
  }

  /// The change of the label by knife triangles that the edge meets exactly at its end, on the way from there.
  static int crossings_at(std::uint32_t end, const Arrangement::Edge& edge) {
    int sum = 0;
    for (const Arrangement::Crossing& c : edge.crossings) {
      if (c.place == end) sum += end == edge.low ? c.sense : -c.sense;
    }
    return sum;
  }

  const Arrangement& all_;
  const ExactPoints& places_;
  std::vector<std::uint32_t> first_part_;  // per facet
  std::vector<Border> borders_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> first_step_;  // per part
  std::vector<int> label_;                 // per part
};

}  // namespace

std::vector<std::vector<int>> windings_of_knife(const Arrangement& all, const ExactPoints& places) {
  return Labeller(all, places).run();
}

}  // namespace pomona
