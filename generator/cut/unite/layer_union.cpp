#include "generator/cut/unite/layer_union.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/disjoint_sets.h"

namespace pomona {

namespace {

constexpr std::int32_t unknown = -2;
constexpr std::int32_t outside = FacetPart::outside;

/// Tries with all bodies, then without those that were refused.
class LayerUniter {
 public:
  LayerUniter(const LayerTask& task, std::vector<glm::dvec3>& place, Threads threads)
      : task_(task), place_(place), threads_(threads) {}

  LayerUnion run() {
    while (true) {
      take_second();
      const std::size_t before = refused_.size();
      const BodyCrossings crossings = body_crossings(task_.first, second_, near_, place_, threads_);
      LayerUnion all{parts_of_side(task_.first, crossings.first, true),
                     parts_of_side(second_, crossings.second, false)};
      refuse_slight(all);
      if (refused_.size() == before) return spread(std::move(all));
    }
  }

 private:
  /// Takes the bodies of the second set that are not refused.
  void take_second() {
    second_.clear();
    number_.clear();
    for (std::uint32_t f = 0; f < task_.second.size(); ++f) {
      if (refused_.contains(task_.second[f].body)) continue;
      second_.push_back(task_.second[f]);
      number_.push_back(f);
    }
    take_near();
  }

  /// Takes the pairs with them, by their numbers here.
  void take_near() {
    constexpr std::uint32_t refused = 0xffffffffu;
    std::vector<std::uint32_t> here(task_.second.size(), refused);
    for (std::uint32_t f = 0; f < number_.size(); ++f) here[number_[f]] = f;
    near_.clear();
    for (const auto& [first, second] : task_.near)
      if (here[second] != refused) near_.emplace_back(first, here[second]);
  }

  UnitedFacets parts_of_side(std::span<const BodyFacet> facets, const CrossedSet& set, bool is_first) {
    UnitedFacets parts;
    parts.part.resize(facets.size());
    std::vector<std::uint8_t> failed(set.crossed.size(), 0);
    constexpr std::size_t facets_a_share = 256;
    parallel_for(1 + set.crossed.size() / facets_a_share, threads_, [&](std::size_t share) {
      const std::size_t end = std::min(set.crossed.size(), (share + 1) * facets_a_share);
      for (std::size_t i = share * facets_a_share; i < end; ++i) {
        std::optional<std::vector<FacetPart>> found = parts_of(set.facet[i], place_);
        failed[i] = found ? 0 : 1;
        if (found) parts.part[set.crossed[i]] = std::move(*found);
      }
    });
    for (std::size_t i = 0; i < set.crossed.size(); ++i) {
      if (failed[i] == 0) continue;
      for (const CrossedFacet::Segment& s : set.facet[i].segment)
        refused_.insert(is_first ? s.body : facets[set.crossed[i]].body);
    }
    label(facets, set, is_first, parts);
    return parts;
  }

  /// Finds the body in which each uncrossed facet lies. Crossings of edges tell it of their ends, and these of all
  /// points that edges connect. Of parts without any crossing, one facet is tested.
  void label(std::span<const BodyFacet> facets, const CrossedSet& set, bool is_first, UnitedFacets& parts) {
    DisjointSets connected = connected_points(facets, set);
    std::vector<std::int32_t> inside(place_.size(), unknown);
    const auto see = [&](std::uint32_t point, std::int32_t body, const EdgeCrossing& by) {
      std::int32_t& known = inside[connected.root(point)];
      if (known != unknown && (known == outside) != (body == outside)) refused_.insert(is_first ? by.body : by.owner);
      known = body;
    };
    for (std::size_t i = 0, end; i < set.crossing.size(); i = end) {
      const EdgeCrossing& first = set.crossing[i];
      for (end = i + 1; end < set.crossing.size(); ++end)
        if (set.crossing[end].low != first.low || set.crossing[end].high != first.high) break;
      const EdgeCrossing& last = set.crossing[end - 1];
      see(first.low, first.enters ? outside : first.body, first);
      see(last.high, last.enters ? last.body : outside, last);
    }

    parts.inside.assign(facets.size(), unknown);
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      if (!parts.part[f].empty()) continue;
      std::int32_t& known = inside[connected.root(facets[f].corner[0])];
      if (known == unknown) known = task_.body_around(is_first, is_first ? f : number_[f]);
      if (refused_.contains(known)) known = outside;
      parts.inside[f] = known;
    }
  }

  /// Sets of points connected by edges that nothing crosses.
  DisjointSets connected_points(std::span<const BodyFacet> facets, const CrossedSet& set) const {
    DisjointSets connected(place_.size());
    std::size_t next = 0;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const std::array<std::uint32_t, 3>& c = facets[f].corner;
      const CrossedFacet* crossed = next < set.crossed.size() && set.crossed[next] == f ? &set.facet[next++] : nullptr;
      for (std::size_t i = 0; i < 3; ++i)
        if (crossed == nullptr || crossed->border[i].empty()) connected.join(c[i], c[(i + 1) % 3]);
    }
    return connected;
  }

  /// Refuses bodies with slight overlaps, whose boundary is what of both sets lies inside.
  void refuse_slight(const LayerUnion& all) {
    std::map<std::int32_t, double> overlap;  // six times the volume
    std::map<std::int32_t, glm::dvec3> origin;
    const auto add = [&](std::int32_t body, const std::array<std::uint32_t, 3>& t) {
      const glm::dvec3& from = origin.try_emplace(body, place_[t[0]]).first->second;
      overlap[body] += glm::dot(place_[t[0]] - from, glm::cross(place_[t[1]] - from, place_[t[2]] - from));
    };
    const auto add_all = [&](std::span<const BodyFacet> facets, const UnitedFacets& parts, bool is_first) {
      for (std::size_t f = 0; f < facets.size(); ++f) {
        if (parts.part[f].empty() && parts.inside[f] != outside)
          add(is_first ? parts.inside[f] : facets[f].body, facets[f].corner);
        for (const FacetPart& part : parts.part[f])
          if (part.inside != outside) add(is_first ? part.inside : facets[f].body, part.corner);
      }
    };
    add_all(task_.first, all.first, true);
    add_all(second_, all.second, false);
    for (const auto& [body, volume] : overlap)
      if (volume < 6 * task_.least_overlap(body)) refused_.insert(body);
  }

  /// The result in the numbers of the task; refused bodies lie outside.
  LayerUnion spread(LayerUnion all) const {
    UnitedFacets second{std::vector<std::vector<FacetPart>>(task_.second.size()),
                        std::vector<std::int32_t>(task_.second.size(), outside)};
    for (std::size_t i = 0; i < number_.size(); ++i) {
      second.part[number_[i]] = std::move(all.second.part[i]);
      second.inside[number_[i]] = all.second.inside[i];
    }
    all.second = std::move(second);
    return all;
  }

  const LayerTask& task_;
  std::vector<glm::dvec3>& place_;
  Threads threads_;
  std::set<std::int32_t> refused_;     // bodies of the second set
  std::vector<BodyFacet> second_;      // that are not refused
  std::vector<std::uint32_t> number_;  // theirs in the task
  std::vector<BoxPair> near_;          // with them
};

}  // namespace

LayerUnion layer_union(const LayerTask& task, std::vector<glm::dvec3>& place, Threads threads) {
  return LayerUniter(task, place, threads).run();
}

}  // namespace pomona
