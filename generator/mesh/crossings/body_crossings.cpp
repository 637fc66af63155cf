#include "generator/mesh/crossings/body_crossings.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/crossings/intersections.h"
#include "generator/mesh/crossings/tie_rule.h"

namespace pomona {

namespace {

/// A crossing as an end of a segment: number 2 i begins segment i, 2 i + 1 ends it.
struct CrossingUse {
  std::uint32_t low = 0, high = 0, facet = 0, number = 0;
  bool of_first = true;  ///< the edge is the first set's
  auto key() const { return std::tuple(!of_first, low, high, facet); }
};

/// The facets of one set that are near any of the other.
class NearFacets {
 public:
  explicit NearFacets(std::size_t facets) : place_(facets, unset) {}

  void add(std::uint32_t facet) { place_[facet] = 0; }

  /// Numbers those that were added, in the order of the facets.
  void number() {
    for (std::uint32_t f = 0; f < place_.size(); ++f) {
      if (place_[f] == unset) continue;
      place_[f] = static_cast<std::uint32_t>(facet_.size());
      facet_.push_back(f);
    }
  }

  std::uint32_t place(std::uint32_t facet) const { return place_[facet]; }
  std::uint32_t facet(std::uint32_t place) const { return facet_[place]; }
  const std::vector<std::uint32_t>& all() const { return facet_; }

 private:
  static constexpr std::uint32_t unset = 0xffffffffu;
  std::vector<std::uint32_t> place_, facet_;
};

class CrossingFinder {
 public:
  CrossingFinder(std::span<const BodyFacet> first, std::span<const BodyFacet> second, std::vector<glm::dvec3>& place)
      : first_(first), second_(second), place_(place) {}

  BodyCrossings run(std::span<const BoxPair> near, Threads threads) {
    find_segments(near, threads);
    find_crossings();
    BodyCrossings result;
    std::vector<std::uint32_t> order(segment_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    collect(order, true, result.first);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return segment_[a].knife < segment_[b].knife; });
    collect(order, false, result.second);
    for (std::size_t c = 0; c < crossing_.size(); ++c)
      (of_first_[c] != 0 ? result.first : result.second).crossing.push_back(crossing_[c]);
    return result;
  }

 private:
  Corners corners(const BodyFacet& facet) const {
    return {place_[facet.corner[0]], place_[facet.corner[1]], place_[facet.corner[2]]};
  }

  /// Of the facets that are near others: most are not.
  void find_segments(std::span<const BoxPair> near, Threads threads) {
    NearFacets first(first_.size()), second(second_.size());
    for (const auto& [f, s] : near) first.add(f), second.add(s);
    first.number(), second.number();
    std::vector<BoxPair> pairs;
    pairs.reserve(near.size());
    for (const auto& [f, s] : near) pairs.emplace_back(first.place(f), second.place(s));
    segment_ = intersections(corners_of(first_, first.all()), corners_of(second_, second.all()), pairs, threads);
    for (Intersection& s : segment_) s.fruit = first.facet(s.fruit), s.knife = second.facet(s.knife);
  }

  std::vector<Corners> corners_of(std::span<const BodyFacet> facets, const std::vector<std::uint32_t>& some) const {
    std::vector<Corners> all;
    all.reserve(some.size());
    for (const std::uint32_t f : some) all.push_back(corners(facets[f]));
    return all;
  }

  const BodyFacet& edge_owner(const Intersection& s, const Crossing& at) const {
    return at.of_fruit ? first_[s.fruit] : second_[s.knife];
  }

  CrossingUse use_of(std::uint32_t number) const {
    const Intersection& s = segment_[number / 2];
    const Crossing& at = number % 2 == 0 ? s.from : s.to;
    const BodyFacet& owner = edge_owner(s, at);
    const std::uint32_t a = owner.corner[at.edge], b = owner.corner[(at.edge + 1) % 3];
    return {std::min(a, b), std::max(a, b), at.of_fruit ? s.knife : s.fruit, number, at.of_fruit};
  }

  EdgeCrossing crossing_of(const CrossingUse& use) const {
    const Intersection& s = segment_[use.number / 2];
    const bool begins = use.number % 2 == 0;
    const Crossing& at = begins ? s.from : s.to;
    const bool forward = edge_owner(s, at).corner[at.edge] == use.low;
    // The first set's edges leave the other body where a segment begins, the second's enter it there.
    const bool enters = (begins != use.of_first) == forward;
    const BodyFacet& facet = use.of_first ? second_[use.facet] : first_[use.facet];
    return {use.low, use.high, use.facet, facet.body, edge_owner(s, at).body, enters, share_of(use, corners(facet)), 0};
  }

  double share_of(const CrossingUse& use, const Corners& facet) const {
    const glm::dvec3 normal = glm::cross(facet[1] - facet[0], facet[2] - facet[0]);
    const double low = glm::dot(normal, place_[use.low] - facet[0]),
                 high = glm::dot(normal, place_[use.high] - facet[0]);
    const double share = low / (low - high);
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5;
  }

  /// Finds each crossing once, in order along its edge, and then its point.
  void find_crossings() {
    std::vector<CrossingUse> uses;
    for (std::uint32_t i = 0; i < 2 * segment_.size(); ++i) uses.push_back(use_of(i));
    std::sort(uses.begin(), uses.end(), [](const CrossingUse& a, const CrossingUse& b) {
      return std::tuple(a.key(), a.number) < std::tuple(b.key(), b.number);
    });
    number_.resize(uses.size());
    for (std::size_t i = 0, end; i < uses.size(); i = end) {
      std::vector<EdgeCrossing> along;
      const auto same_edge = [&](const CrossingUse& use) {
        return use.of_first == uses[i].of_first && use.low == uses[i].low && use.high == uses[i].high;
      };
      const auto first = static_cast<std::uint32_t>(crossing_.size());
      for (end = i; end < uses.size() && same_edge(uses[end]); ++end) {
        if (along.empty() || along.back().facet != uses[end].facet) along.push_back(crossing_of(uses[end]));
      }
      put_in_order(along, uses[i].of_first);
      for (std::size_t k = i; k < end; ++k) {
        const auto at =
            std::find_if(along.begin(), along.end(), [&](const EdgeCrossing& c) { return c.facet == uses[k].facet; });
        number_[uses[k].number] = first + static_cast<std::uint32_t>(at - along.begin());
      }
      for (EdgeCrossing& c : along) {
        c.point = static_cast<std::uint32_t>(place_.size());
        place_.push_back(glm::mix(place_[c.low], place_[c.high], c.share));
        crossing_.push_back(c);
        of_first_.push_back(uses[i].of_first ? 1 : 0);
      }
    }
  }

  void put_in_order(std::vector<EdgeCrossing>& along, bool of_first) const {
    if (along.size() < 2) return;
    constexpr double near = 1e-9;  // of the edge's length: nearer crossings are compared exactly
    const auto order = [&](const EdgeCrossing& a, const EdgeCrossing& b) {
      if (std::fabs(a.share - b.share) > near) return a.share < b.share ? -1 : 1;
      const std::span<const BodyFacet> other = of_first ? second_ : first_;
      return order_along(place_[a.low], place_[a.high], corners(other[a.facet]), corners(other[b.facet]));
    };
    std::stable_sort(along.begin(), along.end(), [&](const EdgeCrossing& a, const EdgeCrossing& b) {
      const int by = order(a, b);
      return by != 0 ? by < 0 : a.facet < b.facet;
    });
    // Crossings at one place enter and leave by turns.
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      if (order(along[i], along[i + 1]) != 0) continue;
      const bool wanted = i > 0 ? !along[i - 1].enters : i + 2 < along.size() ? along[i + 2].enters : true;
      if (along[i].enters != wanted && along[i + 1].enters == wanted) std::swap(along[i], along[i + 1]);
    }
  }

  /// \param order of the segments: those of one facet lie side by side.
  void collect(const std::vector<std::uint32_t>& order, bool is_first, CrossedSet& set) const {
    const auto facet_of = [&](std::uint32_t s) { return is_first ? segment_[s].fruit : segment_[s].knife; };
    for (std::size_t i = 0, end; i < order.size(); i = end) {
      const std::uint32_t number = facet_of(order[i]);
      CrossedFacet facet;
      facet.corner = (is_first ? first_ : second_)[number].corner;
      std::array<std::vector<std::uint32_t>, 3> on_edge;  // crossings
      for (end = i; end < order.size() && facet_of(order[end]) == number; ++end) {
        const std::uint32_t s = order[end];
        const std::uint32_t begins = number_[2 * s], ends = number_[2 * s + 1];
        const std::int32_t body = is_first ? second_[segment_[s].knife].body : first_[segment_[s].fruit].body;
        if (is_first)
          facet.segment.push_back({crossing_[begins].point, crossing_[ends].point, body});
        else
          facet.segment.push_back({crossing_[ends].point, crossing_[begins].point, body});
        if (segment_[s].from.of_fruit == is_first) on_edge[segment_[s].from.edge].push_back(begins);
        if (segment_[s].to.of_fruit == is_first) on_edge[segment_[s].to.edge].push_back(ends);
      }
      for (std::size_t e = 0; e < 3; ++e) {
        std::sort(on_edge[e].begin(), on_edge[e].end());
        if (facet.corner[e] > facet.corner[(e + 1) % 3]) std::reverse(on_edge[e].begin(), on_edge[e].end());
        for (const std::uint32_t c : on_edge[e]) facet.border[e].push_back(crossing_[c].point);
      }
      set.crossed.push_back(number);
      set.facet.push_back(std::move(facet));
    }
  }

  std::span<const BodyFacet> first_, second_;
  std::vector<glm::dvec3>& place_;
  std::vector<Intersection> segment_;
  std::vector<EdgeCrossing> crossing_;
  std::vector<std::uint8_t> of_first_;  // per crossing: its edge is the first set's
  std::vector<std::uint32_t> number_;   // crossing, per end of a segment
};

}  // namespace

BodyCrossings body_crossings(std::span<const BodyFacet> first, std::span<const BodyFacet> second,
                             std::span<const BoxPair> near, std::vector<glm::dvec3>& place, Threads threads) {
  if (near.empty()) return {};
  return CrossingFinder(first, second, place).run(near, threads);
}

}  // namespace pomona
