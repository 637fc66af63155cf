#include "generator/cut/carve/arrangement.h"

#include <algorithm>

#include "generator/base/error.h"
#include "generator/mesh/crossings/intersections.h"
#include "generator/mesh/edge_map.h"

namespace pomona {

namespace {

constexpr int max_rounds = 50;

class Arranger {
 public:
  Arranger(std::span<const PlaceTriangle> fruit, std::span<const PlaceTriangle> knife, ExactPoints& places)
      : places_(places) {
    all_.fruit_count = fruit.size();
    take(fruit);
    take(knife);
  }

  Arrangement run() {
    find_segments();
    split();
    return std::move(all_);
  }

 private:
  void take(std::span<const PlaceTriangle> triangles) {
    EdgeMap<std::uint32_t> edge_of;
    for (const PlaceTriangle& t : triangles) {
      Arrangement::Facet facet;
      facet.corner = t;
      facet.mesh.triangle = {t};
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeKey ends(t[i], t[(i + 1) % 3]);
        const auto [edge, is_new] = edge_of.try_emplace(ends, all_.edge.size());
        if (is_new) all_.edge.push_back({ends.low, ends.high, {}, {}, {}});
        facet.edge[i] = edge;
        all_.edge[edge].facets.push_back(static_cast<std::uint32_t>(all_.facet.size()));
      }
      all_.facet.push_back(std::move(facet));
    }
  }

  std::vector<Corners> corners(std::size_t begin, std::size_t end) const {
    std::vector<Corners> all;
    for (std::size_t f = begin; f < end; ++f) {
      const PlaceTriangle& t = all_.facet[f].corner;
      all.push_back({places_.at(t[0]), places_.at(t[1]), places_.at(t[2])});
    }
    return all;
  }

  void find_segments() {
    const std::vector<Corners> fruit = corners(0, all_.fruit_count),
                               knife = corners(all_.fruit_count, all_.facet.size());
    for (const Intersection& m : intersections(fruit, knife)) {
      const auto other = static_cast<std::uint32_t>(m.knife + all_.fruit_count);
      const Arrangement::Segment segment{
          place_of(m.from, m.fruit, other, true), place_of(m.to, m.fruit, other, false), m.fruit, other, {}};
      for (const std::uint32_t f : {m.fruit, other}) {
        all_.facet[f].segment.push_back(static_cast<std::uint32_t>(all_.segment.size()));
      }
      all_.segment.push_back(segment);
    }
  }

  /// The point of a crossing: the same for all triangles at the edge. Along a fruit's triangle a segment begins where
  /// the triangle's edge leaves the knife, along the knife's where the edge enters the back of the fruit's.
  std::uint32_t place_of(const Crossing& crossing, std::uint32_t fruit, std::uint32_t knife, bool is_begin) {
    const Arrangement::Facet& own = all_.facet[crossing.of_fruit ? fruit : knife];
    const std::uint32_t through = crossing.of_fruit ? knife : fruit;
    Arrangement::Edge& edge = all_.edge[own.edge[crossing.edge]];
    for (const Arrangement::Crossing& known : edge.crossings)
      if (known.facet == through) return known.place;
    const std::uint32_t place = places_.intersection(edge.low, edge.high, all_.facet[through].corner);
    const bool to_back = is_begin != crossing.of_fruit, forward = own.corner[crossing.edge] == edge.low;
    edge.crossings.push_back({place, through, to_back == forward ? 1 : -1});
    add_to(edge, place);
    return place;
  }

  static bool has(const std::vector<std::uint32_t>& places, std::uint32_t place) {
    return std::find(places.begin(), places.end(), place) != places.end();
  }

  bool add_to(Arrangement::Edge& edge, std::uint32_t place) const {
    if (place == edge.low || place == edge.high || has(edge.places, place)) return false;
    edge.places.push_back(place);
    return true;
  }

  bool add_to(Arrangement::Segment& segment, std::uint32_t place) const {
    if (place == segment.from || place == segment.to || has(segment.places, place)) return false;
    segment.places.push_back(place);
    return true;
  }

  /// Triangulates facets until none finds a place on its edges or segments that its neighbours there do not know. The
  /// knife's facets come first, because surfaces cross each other there.
  void split() {
    waits_.assign(all_.facet.size(), 0);
    for (std::size_t f = 0; f < all_.facet.size(); ++f) waits_[f] = patched(f).places.empty() ? 0 : 1;
    for (int round = 0; round < max_rounds; ++round) {
      if (std::find(waits_.begin(), waits_.end(), 1) == waits_.end()) return;
      for (std::size_t f = all_.fruit_count; f < all_.facet.size(); ++f) split(f);
      for (std::size_t f = 0; f < all_.fruit_count; ++f) split(f);
    }
    throw Error(ExitStatus::bug, "a knife's surface and a fruit do not come to terms");
  }

  void split(std::size_t number) {
    if (!waits_[number]) return;
    waits_[number] = 0;
    Arrangement::Facet& facet = all_.facet[number];
    facet.mesh = places_.triangulated(patched(number));
    for (std::size_t i = 0; i < 3; ++i) {
      Arrangement::Edge& edge = all_.edge[facet.edge[i]];
      bool news = false;
      for (const std::uint32_t place : facet.mesh.chain[i]) news = add_to(edge, place) || news;
      if (news) wake(edge.facets, number);
    }
    for (std::size_t i = 0; i < facet.segment.size(); ++i) {
      Arrangement::Segment& segment = all_.segment[facet.segment[i]];
      bool news = false;
      for (const std::uint32_t place : facet.mesh.chain[3 + i]) news = add_to(segment, place) || news;
      if (news) wake({segment.fruit, segment.knife}, number);
    }
  }

  void wake(const std::vector<std::uint32_t>& facets, std::size_t but) {
    for (const std::uint32_t f : facets) {
      if (f != but) waits_[f] = 1;
    }
  }

  PatchedFacet patched(std::size_t number) const {
    const Arrangement::Facet& facet = all_.facet[number];
    PatchedFacet result;
    result.corner = facet.corner;
    const auto append = [&](const std::vector<std::uint32_t>& places) {
      result.places.insert(result.places.end(), places.begin(), places.end());
    };
    for (const std::uint32_t e : facet.edge) append(all_.edge[e].places);
    for (const std::uint32_t s : facet.segment) {
      const Arrangement::Segment& segment = all_.segment[s];
      result.segments.push_back({segment.from, segment.to});
      append({segment.from, segment.to});
      append(segment.places);
    }
    return result;
  }

  ExactPoints& places_;
  Arrangement all_;
  std::vector<std::uint8_t> waits_;  // per facet
};

}  // namespace

Arrangement arranged(std::span<const PlaceTriangle> fruit, std::span<const PlaceTriangle> knife, ExactPoints& places) {
  return Arranger(fruit, knife, places).run();
}

}  // namespace pomona
