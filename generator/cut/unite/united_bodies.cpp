#include "generator/cut/unite/united_bodies.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/unite/earlier_boxes.h"
#include "generator/cut/unite/layer_union.h"
#include "generator/mesh/crossings/tie_rule.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/enclosures.h"
#include "generator/mesh/overlapping_boxes.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// An overlap that is less than this share of a body only touches.
constexpr double min_overlap = 1e-9;

using WallCorners = std::array<std::uint32_t, 3>;  // points

/// A boundary triangle as it faces air, or a part of one.
struct Wall {
  BodyFacet facet;
  std::uint32_t source = 0;                   ///< triangle of the surfaces
  bool is_whole = true;                       ///< all of that triangle
  bool is_inside = false;                     ///< of another body
  bool is_parted = false;                     ///< its parts replace it
  std::int32_t also_of = FacetPart::outside;  ///< a body that stays apart, and ends here
};

std::size_t index(std::int32_t body) { return static_cast<std::size_t>(body); }

bool holds(const Box<double>& box, const glm::dvec3& p) { return box.meets({p, p}); }

/// The boundaries of closed bodies, and which of them could meet.
class BodyWalls {
 public:
  BodyWalls(const DiffusionSurfaces& surfaces, const Bodies& bodies) : surfaces_(surfaces), bodies_(bodies) {
    box_.resize(bodies.bodies.size());
    for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
      if (!takes_part(bodies.of_triangle[t])) continue;
      for (int k = 0; k < 3; ++k)
        box_[index(bodies.of_triangle[t])].add(glm::dvec3(surfaces.position[surfaces.triangle[t][k]]));
    }
    std::vector<std::uint32_t> number;
    std::vector<Box<float>> boxes;  // their corners are floats
    for (std::uint32_t b = 0; b < box_.size(); ++b) {
      if (!takes_part(static_cast<std::int32_t>(b))) continue;
      number.push_back(b);
      boxes.push_back({glm::vec3(box_[b].low), glm::vec3(box_[b].high)});
    }
    met_.resize(box_.size());
    for (const auto& [i, k] : overlapping_boxes(boxes)) {
      met_[number[i]].push_back(static_cast<std::int32_t>(number[k]));
      met_[number[k]].push_back(static_cast<std::int32_t>(number[i]));
      meet_ = true;
    }
  }

  bool meet() const { return meet_; }
  const std::vector<std::int32_t>& met(std::size_t body) const { return met_[body]; }
  const Box<double>& box(std::int32_t body) const { return box_[index(body)]; }
  std::size_t count() const { return box_.size(); }

  bool takes_part(std::int32_t body) const {
    return body != Bodies::none && bodies_.bodies[index(body)].closed && bodies_.bodies[index(body)].volume > 0;
  }

  /// The boundaries' triangles, without those that are lines.
  std::vector<Wall> walls() const {
    const std::vector<std::uint32_t> first = weld(surfaces_.position);
    std::vector<Wall> all;
    for (std::uint32_t t = 0; t < surfaces_.triangle_count(); ++t) {
      if (!takes_part(bodies_.of_triangle[t])) continue;
      const glm::uvec3& v = surfaces_.triangle[t];
      const bool turned = surfaces_.is_hidden(t, SideOf::back);
      const WallCorners c{first[v.x], first[turned ? v.z : v.y], first[turned ? v.y : v.z]};
      if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) all.push_back({{c, bodies_.of_triangle[t]}, t});
    }
    return all;
  }

 private:
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
  std::vector<Box<double>> box_;
  std::vector<std::vector<std::int32_t>> met_;
  bool meet_ = false;
};

/// Whether bodies wind around a point of another body's boundary.
class BodyWindings {
 public:
  BodyWindings(const std::vector<Wall>& walls, std::size_t bodies) : walls_of_(bodies), columns_(bodies) {
    for (const Wall& wall : walls) walls_of_[index(wall.facet.body)].push_back(wall.facet.corner);
  }

  /// \param body_moves by the tie rule the body moves, not the point.
  bool contains(std::int32_t body, const glm::dvec3& point, bool body_moves, const std::vector<glm::dvec3>& place) {
    const std::vector<WallCorners>& walls = walls_of_[index(body)];
    int sum = 0;
    const auto add = [&](const WallCorners& c) {
      const Corners corners{place[c[0]], place[c[1]], place[c[2]]};
      sum += body_moves ? winding_of_knife(corners, point) : winding_of_fruit(corners, point);
    };
    constexpr std::size_t few = 256;
    if (walls.size() <= few) {
      for (const WallCorners& c : walls) add(c);
    } else {
      for (const std::uint32_t t : columns(body, place).over(point)) add(walls[t]);
    }
    return sum > 0;
  }

 private:
  const Enclosures& columns(std::int32_t body, const std::vector<glm::dvec3>& place) {
    std::optional<Enclosures>& known = columns_[index(body)];
    if (known) return *known;
    std::vector<Enclosures::Triangle> triangles;
    for (const WallCorners& c : walls_of_[index(body)])
      triangles.push_back({{place[c[0]], place[c[1]], place[c[2]]}, 0});
    return known.emplace(std::move(triangles));
  }

  std::vector<std::vector<WallCorners>> walls_of_;
  std::vector<std::optional<Enclosures>> columns_;
};

/// Unites layer after layer. The boxes of a layer's bodies lie apart, so that each body meets only bodies of earlier
/// layers, which no longer overlap.
class BodyUniter {
  static constexpr std::uint32_t unset = 0xffffffffu;

 public:
  BodyUniter(const BodyWalls& bodies, const Bodies& known, std::vector<glm::dvec3> place, const UniteOptions& options)
      : bodies_(bodies),
        known_(known),
        place_(std::move(place)),
        options_(options),
        wall_(bodies.walls()),
        windings_(wall_, bodies.count()),
        united_(bodies.count()) {
    find_near();
    find_layers(false);
    find_layers(true);
    find_earlier();
    for (layer_ = 1; layer_ < layers_; ++layer_) unite_layer();
  }

  bool changed() const { return changed_; }
  const std::vector<Wall>& walls() const { return wall_; }
  const std::vector<glm::dvec3>& place() const { return place_; }
  std::int32_t body_now(std::int32_t body) {
    return static_cast<std::int32_t>(united_.root(static_cast<std::uint32_t>(body)));
  }

 private:
  /// Finds the bodies whose boxes each triangle is near, and the walls of each body that are near any. Consecutive
  /// triangles are neighbours in most cases: one box around them excludes most bodies.
  void find_near() {
    near_wall_.resize(bodies_.count());
    near_begin_.reserve(wall_.size() + 1);
    constexpr std::uint32_t row = 32;
    std::vector<Box<double>> box(row);
    std::vector<std::int32_t> near_row;
    for (std::uint32_t begin = 0, end = 0; begin < wall_.size(); begin = end) {
      const std::size_t body = index(wall_[begin].facet.body);
      Box<double> around;
      for (end = begin; end < wall_.size() && end < begin + row && index(wall_[end].facet.body) == body; ++end) {
        box[end - begin] = box_of(end);
        around.add(box[end - begin]);
      }
      near_row.clear();
      for (const std::int32_t other : bodies_.met(body))
        if (around.meets(bodies_.box(other))) near_row.push_back(other);
      for (std::uint32_t w = begin; w < end; ++w) {
        near_begin_.push_back(static_cast<std::uint32_t>(near_.size()));
        for (const std::int32_t other : near_row)
          if (box[w - begin].meets(bodies_.box(other))) near_.push_back(other);
        if (near_.size() > near_begin_.back()) near_wall_[body].push_back(w);
      }
    }
    near_begin_.push_back(static_cast<std::uint32_t>(near_.size()));
    first_part_ = static_cast<std::uint32_t>(wall_.size());
  }

  /// The bodies near a wall, or near the wall of which it is a part.
  std::span<const std::int32_t> near(std::uint32_t wall) const {
    const std::uint32_t whole = whole_of(wall);
    return std::span(near_).subspan(near_begin_[whole], near_begin_[whole + 1] - near_begin_[whole]);
  }

  bool is_apart(std::int32_t body) const {
    return std::find(options_.apart.begin(), options_.apart.end(), body) != options_.apart.end();
  }

  /// Puts bodies into layers, those with many triangles first; bodies that stay apart come last.
  void find_layers(bool apart) {
    std::vector<std::size_t> size(bodies_.count(), 0);
    for (const Wall& wall : wall_) ++size[index(wall.facet.body)];
    std::vector<std::uint32_t> order(bodies_.count());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
    const int first = layers_;
    layer_of_.resize(bodies_.count(), -1);
    for (const std::uint32_t body : order) {
      if (is_apart(static_cast<std::int32_t>(body)) != apart) continue;
      std::vector<int> taken;
      for (const std::int32_t other : bodies_.met(body)) taken.push_back(layer_of_[index(other)]);
      int layer = first;
      while (std::find(taken.begin(), taken.end(), layer) != taken.end()) ++layer;
      layer_of_[body] = layer;
      layers_ = std::max(layers_, layer + 1);
    }
  }

  bool is_other(bool of_first, std::int32_t body) const {
    return of_first ? layer_of_[index(body)] == layer_ : layer_of_[index(body)] < layer_;
  }

  /// The walls of earlier bodies that are near a body of this layer, or the reverse.
  std::vector<std::uint32_t> concerned(bool of_first) const {
    std::vector<std::uint32_t> walls;
    for (std::size_t b = 0; b < bodies_.count(); ++b) {
      if (is_other(of_first, static_cast<std::int32_t>(b)) || layer_of_[b] > layer_) continue;
      const std::vector<std::int32_t>& met = bodies_.met(b);
      if (std::none_of(met.begin(), met.end(), [&](std::int32_t body) { return is_other(of_first, body); })) continue;
      for (const std::uint32_t w : near_wall_[b]) {
        if (wall_[w].is_inside || wall_[w].is_parted) continue;
        const std::span<const std::int32_t> by = near(w);
        if (std::any_of(by.begin(), by.end(), [&](std::int32_t body) { return is_other(of_first, body); }))
          walls.push_back(w);
      }
    }
    return walls;
  }

  /// Finds, for each whole wall, those of earlier layers whose boxes meet: once for all layers, for what crosses a part
  /// of a wall is near the wall. Boxes are a little larger, because the corners of parts are rounded.
  void find_earlier() {
    Box<double> all;
    for (const glm::dvec3& p : place_) all.add(p);
    const auto margin = static_cast<float>(1e-9 * glm::length(all.size()));
    std::vector<Box<float>> box(first_part_);
    std::vector<int> layer(first_part_, EarlierBoxes::no_layer);
    for (std::uint32_t w = 0; w < first_part_; ++w) {
      if (near(w).empty()) continue;
      const Box<double> own = box_of(w);
      box[w] = {glm::vec3(own.low) - margin, glm::vec3(own.high) + margin};
      layer[w] = layer_of_[index(wall_[w].facet.body)];
    }
    earlier_.emplace(box, layer);
    newest_.assign(first_part_, unset);
  }

  Box<double> box_of(std::uint32_t wall) const {
    const WallCorners& c = wall_[wall].facet.corner;
    return box_around(place_[c[0]], place_[c[1]], place_[c[2]]);
  }

  std::uint32_t whole_of(std::uint32_t wall) const { return wall < first_part_ ? wall : part_of_[wall - first_part_]; }

  /// The pairs of a first and a second wall, by their places in the lists, whose boxes meet. The second ones are whole.
  std::vector<BoxPair> near_pairs(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) {
    // Parts of one wall form a chain.
    std::vector<std::uint32_t> before(first.size());
    for (std::uint32_t i = 0; i < first.size(); ++i) before[i] = std::exchange(newest_[whole_of(first[i])], i);
    std::vector<Box<double>> box(first.size());  // found where it is asked for
    std::vector<BoxPair> pairs;
    for (std::uint32_t k = 0; k < second.size(); ++k) {
      const Box<double> own = box_of(second[k]);
      for (const std::uint32_t whole : earlier_->of(second[k])) {
        for (std::uint32_t i = newest_[whole]; i != unset; i = before[i]) {
          if (box[i].low.x > box[i].high.x) box[i] = box_of(first[i]);
          if (box[i].meets(own)) pairs.emplace_back(i, k);
        }
      }
    }
    for (const std::uint32_t wall : first) newest_[whole_of(wall)] = unset;
    return pairs;
  }

  std::vector<BodyFacet> facets(const std::vector<std::uint32_t>& walls) const {
    std::vector<BodyFacet> all;
    for (const std::uint32_t w : walls) all.push_back(wall_[w].facet);
    return all;
  }

  void unite_layer() {
    const std::vector<std::uint32_t> first = concerned(true), second = concerned(false);
    if (first.empty() && second.empty()) return;
    const std::vector<BodyFacet> first_facets = facets(first), second_facets = facets(second);
    const std::vector<BoxPair> pairs = near_pairs(first, second);
    LayerTask task{first_facets, second_facets, pairs, {}, {}};
    task.body_around = [&](bool of_first, std::uint32_t facet) {
      const std::uint32_t wall = of_first ? first[facet] : second[facet];
      const glm::dvec3& point = place_[wall_[wall].facet.corner[0]];
      for (const std::int32_t body : near(wall)) {
        if (!is_other(of_first, body) || !holds(bodies_.box(body), point)) continue;
        if (windings_.contains(body, point, of_first, place_)) return body;
      }
      return FacetPart::outside;
    };
    task.least_overlap = [&](std::int32_t body) { return min_overlap * known_.bodies[index(body)].volume; };
    const LayerUnion all = layer_union(task, place_, options_.threads);
    take(first, all.first);
    take(second, all.second);
  }

  void take(const std::vector<std::uint32_t>& walls, const UnitedFacets& all) {
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const std::uint32_t w = walls[i];
      if (all.part[i].empty()) {
        place_inside(wall_[w], all.inside[i]);
        continue;
      }
      wall_[w].is_parted = true;
      for (const FacetPart& part : all.part[i]) {
        Wall one{{part.corner, wall_[w].facet.body}, wall_[w].source, false};
        place_inside(one, part.inside);
        near_wall_[index(one.facet.body)].push_back(static_cast<std::uint32_t>(wall_.size()));
        part_of_.push_back(whole_of(w));
        wall_.push_back(one);
      }
    }
  }

  /// Places a wall inside a body. Where one of two bodies stays apart, it ends there; else they become one.
  void place_inside(Wall& wall, std::int32_t body) {
    if (body == FacetPart::outside) return;
    changed_ = true;
    const std::int32_t own = wall.facet.body;
    const bool ends = is_apart(own) && (!is_apart(body) || layer_of_[index(own)] > layer_of_[index(body)]);
    wall.is_inside = ends || !is_apart(body);
    if (!wall.is_inside) wall.also_of = body;
    if (!is_apart(own) && !is_apart(body))
      united_.join(static_cast<std::uint32_t>(own), static_cast<std::uint32_t>(body));
  }

  const BodyWalls& bodies_;
  const Bodies& known_;
  std::vector<glm::dvec3> place_;
  const UniteOptions& options_;
  std::vector<Wall> wall_;  // the parts behind the whole ones
  BodyWindings windings_;
  DisjointSets united_;                                // of bodies
  std::vector<std::int32_t> near_;                     // bodies, whole wall by whole wall
  std::vector<std::uint32_t> near_begin_;              // per whole wall: its first
  std::vector<std::vector<std::uint32_t>> near_wall_;  // per body
  std::uint32_t first_part_ = 0;
  std::vector<std::uint32_t> part_of_;   // per part: the whole wall
  std::vector<int> layer_of_;            // per body
  std::optional<EarlierBoxes> earlier_;  // per whole wall
  std::vector<std::uint32_t> newest_;    // per whole wall: the last of its parts in a list, or none
  int layers_ = 0, layer_ = 0;
  bool changed_ = false;
};

/// Makes the surfaces, with walls divided or made inner ones.
class SurfaceUniter {
  static constexpr std::uint32_t unset = 0xffffffffu;

  /// The vertex of a triangle at a point.
  struct Made {
    std::uint32_t source = unset, vertex = unset;
  };

 public:
  SurfaceUniter(const DiffusionSurfaces& surfaces, BodyUniter& uniter)
      : from_(surfaces), uniter_(uniter), place_(uniter.place()), made_(place_.size()) {
    sort_walls();
  }

  UnitedBodies run(const Bodies& bodies) {
    to_ = from_;
    to_.triangle.clear(), to_.surface.clear(), to_.front_part.clear(), to_.back_part.clear(), to_.instance.clear();
    const std::size_t triangles = from_.triangle_count() + wall_.size();
    to_.triangle.reserve(triangles), to_.surface.reserve(triangles);
    to_.front_part.reserve(triangles), to_.back_part.reserve(triangles);
    result_.bodies = bodies;
    result_.bodies.of_triangle.clear();
    result_.bodies.of_triangle.reserve(triangles);
    for (std::uint32_t t = 0; t < from_.triangle_count(); ++t) {
      const std::int32_t body = bodies.of_triangle[t];
      const std::int32_t now = body == Bodies::none ? body : uniter_.body_now(body);
      if (wall_begin_[t] == wall_begin_[t + 1]) add(t, from_.triangle[t], now);
      for (std::uint32_t w = wall_begin_[t]; w < wall_begin_[t + 1]; ++w) add_wall(uniter_.walls()[wall_[w]], now);
    }
    result_.surfaces = std::move(to_);
    return std::move(result_);
  }

 private:
  /// Sorts the walls that are not divided by triangle.
  void sort_walls() {
    const std::vector<Wall>& walls = uniter_.walls();
    wall_begin_.assign(from_.triangle_count() + 1, 0);
    for (const Wall& wall : walls)
      if (!wall.is_parted) ++wall_begin_[wall.source + 1];
    std::partial_sum(wall_begin_.begin(), wall_begin_.end(), wall_begin_.begin());
    wall_.resize(wall_begin_.back());
    std::vector<std::uint32_t> next(wall_begin_.begin(), wall_begin_.end() - 1);
    for (std::uint32_t w = 0; w < walls.size(); ++w)
      if (!walls[w].is_parted) wall_[next[walls[w].source]++] = w;
  }

  void add(std::uint32_t source, const glm::uvec3& triangle, std::int32_t body) {
    to_.triangle.push_back(triangle);
    to_.surface.push_back(from_.surface[source]);
    to_.front_part.push_back(from_.front_part[source]);
    to_.back_part.push_back(from_.back_part[source]);
    if (!from_.instance.empty()) to_.instance.push_back(from_.instance[source]);
    result_.bodies.of_triangle.push_back(body);
  }

  void add_wall(const Wall& wall, std::int32_t body) {
    glm::uvec3 vertex = from_.triangle[wall.source];
    if (!wall.is_whole) {
      for (int k = 0; k < 3; ++k) vertex[k] = vertex_at(wall, wall.facet.corner[static_cast<std::size_t>(k)]);
      if (from_.is_hidden(wall.source, SideOf::back)) std::swap(vertex.y, vertex.z);
    }
    if (wall.also_of != FacetPart::outside) add(wall.source, changed(vertex, ended_), wall.also_of);
    if (wall.is_inside)
      add(wall.source, changed(vertex, inner_), Bodies::none);
    else
      add(wall.source, vertex, body);
  }

  /// The vertex at a point: one of the triangle, or one on an edge, which its neighbour shares, or one within it.
  std::uint32_t vertex_at(const Wall& wall, std::uint32_t point) {
    const glm::uvec3& v = from_.triangle[wall.source];
    const glm::dvec3& p = place_[point];
    for (int k = 0; k < 3; ++k)
      if (glm::dvec3(from_.position[v[k]]) == p) return v[k];
    Made& made = made_[point];
    if (made.source == wall.source) return made.vertex;
    made = {wall.source, add_vertex_within(to_, from_, v, p)};
    const bool front_hidden = from_.is_hidden(wall.source, SideOf::front);
    to_.front_hidden.back() = front_hidden ? 1 : 0;
    to_.back_hidden.back() = front_hidden ? 0 : 1;
    return made.vertex;
  }

  using Copies = std::vector<std::uint32_t>;  // by vertex

  /// The triangle with other hidden sides: none in `inner_`, the visible ones in `ended_`.
  glm::uvec3 changed(glm::uvec3 triangle, Copies& copies) {
    for (int k = 0; k < 3; ++k) {
      if (copies.size() <= triangle[k]) copies.resize(to_.vertex_count(), unset);
      if (copies[triangle[k]] == unset) {
        const std::uint32_t copy = doubled_vertex(to_, triangle[k]);
        copies[triangle[k]] = copy;
        std::uint8_t &front = to_.front_hidden[copy], &back = to_.back_hidden[copy];
        std::swap(front, back);
        if (&copies == &inner_) front = back = 0;
      }
      triangle[k] = copies[triangle[k]];
    }
    return triangle;
  }

  const DiffusionSurfaces& from_;
  BodyUniter& uniter_;
  const std::vector<glm::dvec3>& place_;
  std::vector<std::uint32_t> wall_, wall_begin_;  // walls that are not parted; per triangle: its first
  std::vector<Made> made_;                        // per point: for the triangle that came last
  Copies inner_, ended_;
  DiffusionSurfaces to_;
  UnitedBodies result_;
};

}  // namespace

std::optional<UnitedBodies> united_bodies(const DiffusionSurfaces& surfaces, const Bodies& bodies,
                                          const UniteOptions& options) {
  const BodyWalls walls(surfaces, bodies);
  if (!walls.meet()) return std::nullopt;
  std::vector<glm::dvec3> place;
  for (const glm::vec3& p : surfaces.position) place.emplace_back(p);
  BodyUniter uniter(walls, bodies, std::move(place), options);
  if (!uniter.changed()) return std::nullopt;
  return SurfaceUniter(surfaces, uniter).run(bodies);
}

}  // namespace pomona
