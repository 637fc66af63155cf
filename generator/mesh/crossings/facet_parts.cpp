#include "generator/mesh/crossings/facet_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "generator/base/cross.h"
#include "generator/mesh/polygon_triangles.h"

namespace pomona {

namespace {

using Polygon = std::vector<std::uint32_t>;  // points, counter-clockwise

/// A polygon, and the body that it lies in.
struct Region {
  Polygon border;
  std::int32_t inside = FacetPart::outside;
};

/// Where the points lie in the plane of two axes, in which the triangle turns counter-clockwise.
class FlatView {
 public:
  FlatView(const CrossedFacet& facet, const std::vector<glm::dvec3>& place) : place_(place) {
    const glm::dvec3 &a = place[facet.corner[0]], &b = place[facet.corner[1]], &c = place[facet.corner[2]];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::fabs(normal[i]) > std::fabs(normal[axis])) axis = i;
    }
    u_ = (axis + 1) % 3;
    v_ = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u_, v_);
  }

  glm::dvec2 at(std::uint32_t point) const { return {place_[point][u_], place_[point][v_]}; }
  const glm::dvec3& in_space(std::uint32_t point) const { return place_[point]; }

  /// Twice the area of a triangle, positive where it turns counter-clockwise.
  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const { return cross(at(b) - at(a), at(c) - at(a)); }
  double area(std::span<const std::uint32_t> polygon) const {
    double sum = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) sum += area(polygon[0], polygon[i - 1], polygon[i]);
    return sum;
  }

 private:
  const std::vector<glm::dvec3>& place_;
  int u_ = 0, v_ = 1;
};

/// Cuts off one corner after another. It always ends with all triangles, however thin rounding makes them.
class EarClipper {
 public:
  EarClipper(const FlatView& view, Polygon polygon) : left_(std::move(polygon)) {
    at_.reserve(left_.size());
    for (const std::uint32_t point : left_) at_.push_back(view.at(point));
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(left_.size() - 2);
    while (left_.size() > 3) {
      const std::size_t ear = best_ear();
      triangles.push_back({left_[before(ear)], left_[ear], left_[after(ear)]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
      at_.erase(at_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : left_.size() - 1; }
  std::size_t after(std::size_t i) const { return i + 1 < left_.size() ? i + 1 : 0; }

  static double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return cross(b - a, c - a); }

  /// The ear with the shortest diagonal; where rounding leaves none, the one with the largest area.
  std::size_t best_ear() const {
    std::size_t best = 0, largest = 0;
    double shortest = std::numeric_limits<double>::infinity(), max = -shortest;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const glm::dvec2 &a = at_[before(i)], &c = at_[after(i)];
      const double size = area(a, at_[i], c);
      if (size > max) max = size, largest = i;
      const glm::dvec2 diagonal = c - a;
      const double square = glm::dot(diagonal, diagonal);
      if (size <= 0 || square >= shortest || !is_empty(i)) continue;
      shortest = square, best = i;
    }
    return std::isinf(shortest) ? largest : best;
  }

  bool is_empty(std::size_t ear) const {
    const std::size_t first = before(ear), last = after(ear);
    const glm::dvec2 &a = at_[first], &b = at_[ear], &c = at_[last];
    for (std::size_t i = 0; i < left_.size(); ++i) {
      // A bridge passes one point twice.
      if (left_[i] == left_[first] || left_[i] == left_[ear] || left_[i] == left_[last]) continue;
      if (area(a, b, at_[i]) >= 0 && area(b, c, at_[i]) >= 0 && area(c, a, at_[i]) >= 0) return false;
    }
    return true;
  }

  Polygon left_;
  std::vector<glm::dvec2> at_;  // per corner that is left
};

class FacetParter {
 public:
  FacetParter(const CrossedFacet& facet, const std::vector<glm::dvec3>& place) : facet_(facet), view_(facet, place) {}

  std::optional<std::vector<FacetPart>> run() {
    lay_ring();
    if (!take_chains()) return std::nullopt;
    const bool found = starts_.empty() ? take_border_whole() : walk_regions();
    if (!found || !cut_out_loops()) return std::nullopt;
    std::size_t corners = 0;
    for (const Region& region : regions_) corners += region.border.size();
    std::vector<FacetPart> parts;
    parts.reserve(corners);
    for (const Region& region : regions_) {
      for (const auto& t : triangles_of(region.border)) parts.push_back({t, region.inside});
    }
    return parts;
  }

 private:
  /// Consecutive segments, from one point of the border to another, or a loop.
  struct Chain {
    Polygon point;
    std::int32_t body = 0;
  };

  void lay_ring() {
    for (std::size_t i = 0; i < 3; ++i) {
      ring_.push_back(facet_.corner[i]);
      ring_.insert(ring_.end(), facet_.border[i].begin(), facet_.border[i].end());
    }
  }

  /// The segment that begins at the point, or none.
  std::optional<std::size_t> segment_from(std::uint32_t point) const {
    for (std::size_t s = 0; s < facet_.segment.size(); ++s)
      if (facet_.segment[s].from == point) return s;
    return std::nullopt;
  }
  /// Takes chains that begin on the border, in its order; then loops.
  bool take_chains() {
    used_.assign(facet_.segment.size(), 0);
    for (std::size_t r = 0; r < ring_.size(); ++r) {
      if (!segment_from(ring_[r])) continue;
      starts_.push_back(r);
      if (!take_chain(ring_[r])) return false;
    }
    on_border_ = chains_.size();
    for (std::size_t s = 0; s < used_.size(); ++s)
      if (!used_[s] && !take_chain(facet_.segment[s].from)) return false;
    return true;
  }

  bool take_chain(std::uint32_t first) {
    Chain chain{{first}, 0};
    for (auto next = segment_from(first); next; next = segment_from(chain.point.back())) {
      if (used_[*next]) return chain.point.back() == first;
      used_[*next] = 1;
      chain.body = facet_.segment[*next].body;
      if (facet_.segment[*next].to == first) break;
      chain.point.push_back(facet_.segment[*next].to);
    }
    chains_.push_back(std::move(chain));
    return true;
  }

  /// Takes a border without a chain: it lies inside if the inside is outside of the largest loop.
  bool take_border_whole() {
    std::int32_t inside = FacetPart::outside;
    double max = 0;
    for (const Chain& loop : chains_) {
      const double area = view_.area(loop.point);
      if (std::fabs(area) <= max) continue;
      max = std::fabs(area);
      inside = area < 0 ? loop.body : FacetPart::outside;
    }
    regions_.push_back({ring_, inside});
    return true;
  }

  /// The next start or end of a chain on the border behind a place.
  std::size_t next_on_ring(std::size_t place, Polygon& border) const {
    for (std::size_t r = (place + 1) % ring_.size();; r = (r + 1) % ring_.size()) {
      if (role_[r] != 0 || r == place) return r;
      border.push_back(ring_[r]);
    }
  }

  /// Walks around regions: the inside lies left of chains. Around the border starts and ends must alternate.
  bool walk_regions() {
    role_.assign(ring_.size(), 0);
    chain_at_.assign(ring_.size(), 0);
    for (std::size_t c = 0; c < on_border_; ++c) {
      const auto end = std::find(ring_.begin(), ring_.end(), chains_[c].point.back());
      if (end == ring_.end() || chains_[c].point.size() < 2) return false;
      const auto place = static_cast<std::size_t>(end - ring_.begin());
      if (role_[starts_[c]] != 0 || role_[place] != 0) return false;
      role_[starts_[c]] = 1;
      role_[place] = -1;
      chain_at_[starts_[c]] = chain_at_[place] = c;
    }
    int last = 0;
    for (std::size_t i = 0; i < 2 * ring_.size(); ++i) {
      const int role = role_[i % ring_.size()];
      if (role != 0 && role == last) return false;
      if (role != 0) last = role;
    }
    for (const int sense : {1, -1}) {
      std::vector<std::uint8_t> done(ring_.size(), 0);
      for (std::size_t r = 0; r < ring_.size(); ++r)
        if (role_[r] == sense && !done[r]) walk_region(r, sense, done);
    }
    return true;
  }

  void walk_region(std::size_t first, int sense, std::vector<std::uint8_t>& done) {
    Region region{{}, sense > 0 ? chains_[chain_at_[first]].body : FacetPart::outside};
    for (std::size_t r = first; !done[r];) {
      done[r] = 1;
      Polygon way = chains_[chain_at_[r]].point;
      if (sense < 0) std::reverse(way.begin(), way.end());
      region.border.insert(region.border.end(), way.begin(), way.end());
      const auto end = std::find(ring_.begin(), ring_.end(), way.back());
      r = next_on_ring(static_cast<std::size_t>(end - ring_.begin()), region.border);
    }
    regions_.push_back(std::move(region));
  }

  bool holds(const Polygon& polygon, std::uint32_t point) const {
    const glm::dvec2 p = view_.at(point);
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = view_.at(polygon[i]), b = view_.at(polygon[(i + 1) % polygon.size()]);
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }

  /// Makes each loop a region of its own, and a hole in the region around it, joined by a bridge.
  bool cut_out_loops() {
    const std::size_t around = regions_.size();
    for (std::size_t c = on_border_; c < chains_.size(); ++c) {
      Polygon loop = chains_[c].point;
      if (loop.size() < 3) return false;
      const bool island = view_.area(loop) > 0;
      const std::int32_t inside = island ? chains_[c].body : FacetPart::outside;
      std::size_t home = 0;
      while (home < around &&
             !((regions_[home].inside == FacetPart::outside) == island && holds(regions_[home].border, loop.front())))
        ++home;
      if (home == around) return false;
      Polygon hole = loop;
      std::reverse(hole.begin(), hole.end());
      bridge(regions_[home].border, island ? hole : loop);
      if (!island) std::reverse(loop.begin(), loop.end());
      regions_.push_back({std::move(loop), inside});
    }
    return true;
  }

  /// Joins a hole by the shortest bridge that crosses nothing. \param hole clockwise.
  void bridge(Polygon& polygon, const Polygon& hole) const {
    struct Way {
      double square;
      std::size_t from, to;
    };
    std::vector<Way> ways;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      for (std::size_t k = 0; k < hole.size(); ++k) {
        const glm::dvec2 way = view_.at(hole[k]) - view_.at(polygon[i]);
        ways.push_back({glm::dot(way, way), i, k});
      }
    }
    std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
      return std::tuple(a.square, a.from, a.to) < std::tuple(b.square, b.from, b.to);
    });
    const auto is_clear = [&](const Way& way) {
      return !crosses(polygon[way.from], hole[way.to], polygon) && !crosses(polygon[way.from], hole[way.to], hole);
    };
    const auto clear = std::find_if(ways.begin(), ways.end(), is_clear);
    const Way& way = clear == ways.end() ? ways.front() : *clear;
    const auto after = polygon.begin() + static_cast<std::ptrdiff_t>(way.from);
    Polygon joined(polygon.begin(), after + 1);
    for (std::size_t k = 0; k <= hole.size(); ++k) joined.push_back(hole[(way.to + k) % hole.size()]);
    joined.insert(joined.end(), after, polygon.end());
    polygon = std::move(joined);
  }

  /// True if the segment passes through an edge at which it neither begins nor ends.
  bool crosses(std::uint32_t from, std::uint32_t to, const Polygon& polygon) const {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::uint32_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a == from || a == to || b == from || b == to) continue;
      if ((view_.area(from, to, a) > 0) == (view_.area(from, to, b) > 0)) continue;
      if ((view_.area(a, b, from) > 0) != (view_.area(a, b, to) > 0)) return true;
    }
    return false;
  }

  std::optional<std::vector<glm::uvec3>> delaunay(const Polygon& polygon) const {
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t p : polygon) corners.push_back(view_.in_space(p));
    return polygon_triangles(corners);
  }

  static bool is_bridged(Polygon polygon) {
    std::sort(polygon.begin(), polygon.end());
    return std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
  }

  /// Whether the triangles have the polygon's border and no other. Points that rounding has put into one place are one
  /// to the Delaunay triangulation, which then leaves out the edge between them.
  static bool is_bordered_by(const std::vector<std::array<std::uint32_t, 3>>& triangles, const Polygon& polygon) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> open;
    const auto pass = [&](std::uint32_t from, std::uint32_t to, int times) {
      open[std::minmax(from, to)] += from < to ? times : -times;
    };
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) pass(t[k], t[(k + 1) % 3], 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) pass(polygon[i], polygon[(i + 1) % polygon.size()], -1);
    return std::all_of(open.begin(), open.end(), [](const auto& edge) { return edge.second == 0; });
  }

  std::vector<std::array<std::uint32_t, 3>> triangles_of(const Polygon& polygon) const {
    // Ears are quicker for few corners: without them, uniting bodies takes 1.3 to 1.4 times as long. But their time
    // grows with the cube of the corners.
    constexpr std::size_t few = 12;
    if (polygon.size() > few || is_bridged(polygon)) {
      if (const auto triangles = delaunay(polygon)) {
        std::vector<std::array<std::uint32_t, 3>> all;
        for (const glm::uvec3& t : *triangles) all.push_back({polygon[t.x], polygon[t.y], polygon[t.z]});
        if (is_bordered_by(all, polygon)) return all;
      }
    }
    return EarClipper(view_, polygon).run();
  }

  const CrossedFacet& facet_;
  const FlatView view_;
  Polygon ring_;                       // the border's points
  std::vector<std::size_t> starts_;    // places on the ring where chains begin
  std::vector<std::uint8_t> used_;     // per segment
  std::vector<Chain> chains_;          // those on the border first
  std::size_t on_border_ = 0;          // how many
  std::vector<int> role_;              // per place on the ring: 1 where a chain begins, -1 where one ends
  std::vector<std::size_t> chain_at_;  // the chain that does
  std::vector<Region> regions_;
};

}  // namespace

std::optional<std::vector<FacetPart>> parts_of(const CrossedFacet& facet, const std::vector<glm::dvec3>& place) {
  return FacetParter(facet, place).run();
}

}  // namespace pomona
