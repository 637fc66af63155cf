#include "generator/cut/plane/split.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/plane/flat_grid.h"
#include "generator/cut/plane/stroke_reach.h"
#include "generator/cut/plane/stroke_sides.h"
#include "generator/knife/exact_side.h"
#include "generator/mesh/box.h"
#include "generator/mesh/edge_map.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

/// The next corner, and the one after.
constexpr std::array<std::size_t, 3> next{1, 2, 0}, after_next{2, 0, 1};

class Splitter {
 public:
  Splitter(const DiffusionSurfaces& surfaces, const CutPlanes& planes)
      : surfaces_(surfaces), planes_(planes), mesh_(planes) {}

  SplitMesh split() {
    take_input();
    int plane = 0;
    for (const KnifePlanes& knife : planes_.knives) {
      const int end = plane + static_cast<int>(knife.planes.size());
      while (plane < end) {
        const CutPlanes::Blade& blade = planes_.blade_of(plane);
        if (blade.stroke)
          split_by_stroke(blade);
        else
          split_by(plane);
        plane += blade.count;
      }
      for (SplitMesh::Triangle& t : mesh_.triangle) {
        t.cell =
            t.cell * static_cast<std::uint32_t>(knife.cell_count()) + static_cast<std::uint32_t>(knife.cell(t.sides));
        t.sides = {};
      }
    }
    return std::move(mesh_);
  }

 private:
  using Triangle = SplitMesh::Triangle;

  void take_input() {
    // Keep vertices as they are; vertices at one place share the point of the first.
    const std::vector<std::uint32_t> welded = weld(surfaces_.position);
    mesh_.point_of = welded;
    mesh_.front_color = surfaces_.front_color;
    mesh_.back_color = surfaces_.back_color;
    mesh_.point.reserve(surfaces_.vertex_count() * 5 / 4);
    for (const glm::vec3& p : surfaces_.position) mesh_.point.emplace_back(p);
    mesh_.planes_of.resize(mesh_.point.size(), 0);
    mesh_.same_as.resize(mesh_.point.size());
    std::iota(mesh_.same_as.begin(), mesh_.same_as.end(), 0u);
    input_points_ = mesh_.point.size();
    find_flat_points();
    find_flush();
    find_points_on_planes();

    // Take the triangles that are no mere lines.
    mesh_.triangle.reserve(surfaces_.triangle_count() * 5 / 4);
    for (std::size_t t = 0; t < surfaces_.triangle_count(); ++t) {
      const glm::uvec3& corner = surfaces_.triangle[t];
      if (is_collapsed({welded[corner.x], welded[corner.y], welded[corner.z]})) continue;
      Triangle triangle;
      triangle.vertex = {corner.x, corner.y, corner.z};
      triangle.source = static_cast<std::uint32_t>(t);
      mesh_.triangle.push_back(triangle);
    }
    find_normals();
  }

  /// Puts the points into a grid, if there are strokes.
  void find_flat_points() {
    const auto is_stroke = [](const CutPlanes::Blade& blade) { return blade.stroke.has_value(); };
    if (std::none_of(planes_.blades.begin(), planes_.blades.end(), is_stroke)) return;
    for (const glm::dvec3& p : mesh_.point) bounds_.add(p);
    flat_points_.emplace(glm::dvec2(bounds_.low), glm::dvec2(bounds_.high), mesh_.point.size());
    for (std::uint32_t p = 0; p < input_points_; ++p) flat_points_->add(p, glm::dvec2(mesh_.point[p]));
  }

  /// What lies nearer to a facet, metres, is looked at: far more than rounding, and than where facets end.
  double near_facet() const { return 2e4 * planes_.tolerance; }

  /// The facet with `more` beyond its ends, metres, as far as there are points.
  FlatStretch stretch(const Stroke::Facet& facet, double more) const {
    const double away = glm::distance(facet.start, glm::dvec2(bounds_.center()));
    return stretch_of(facet, more, away + glm::length(bounds_.size()));
  }

  /// The points that may lie on the facet's plane, in ascending order.
  std::vector<std::uint32_t> points_near_plane(const Stroke::Facet& facet) const {
    const FlatStretch line = stretch(facet, std::numeric_limits<double>::infinity());
    return flat_points_->near(line.from, line.to, near_facet());
  }

  /// Metres: flat faces no farther from a turned plane lie in it. Their corners, rounded to floats, lie within a step
  /// of floats of the face's own plane; knives along it, by numbers that somebody has computed, within a few more.
  void find_flush() {
    constexpr double steps = 4, step = 0x1p-23;
    double square = 0;
    for (std::size_t p = 0; p < input_points_; ++p) square = std::max(square, glm::dot(mesh_.point[p], mesh_.point[p]));
    flush_ = steps * step * std::sqrt(square);
  }

  /// Leaves a gap: what is not flush lies twice as far away as what is. Where faces lay on both sides of a limit,
  /// rounding would say of each which side it is on, and planes that meet there would not fit together.
  void widen_flush() {
    const double widest = 8 * flush_;
    std::vector<double> distances;  // of triangles, by their farthest corner
    for (int plane = 0; plane < planes_.count(); ++plane) {
      if (planes_[plane].same_as != plane || !is_turned(plane)) continue;
      for (std::size_t t = 0; t < surfaces_.triangle_count(); ++t) {
        if (!surfaces_.is_boundary(t)) continue;
        const glm::uvec3& corner = surfaces_.triangle[t];
        double farthest = 0;
        for (int k = 0; k < 3 && farthest <= widest; ++k)
          farthest = std::max(farthest, std::fabs(signed_distance(planes_[plane].plane, mesh_.point[corner[k]])));
        if (farthest <= widest && !is_thin(welded_corners(t))) distances.push_back(farthest);
      }
    }
    std::sort(distances.begin(), distances.end());
    for (const double distance : distances)
      if (distance <= 2 * flush_) flush_ = std::max(flush_, distance);
  }

  std::array<std::uint32_t, 3> welded_corners(std::size_t triangle) const {
    const glm::uvec3& corner = surfaces_.triangle[triangle];
    return {mesh_.point_of[corner.x], mesh_.point_of[corner.y], mesh_.point_of[corner.z]};
  }

  /// All before the first split: a point made between two that lie on a plane is then known to lie on it, too.
  void find_points_on_planes() {
    // One plane alone cuts right however near it lies; it takes two for rounding to leave something open.
    int turned = 0;
    for (int plane = 0; plane < planes_.count(); ++plane) turned += is_turned(plane) ? 1 : 0;
    if (turned > 1) widen_flush();
    for (int plane = 0; plane < planes_.count(); ++plane) {
      if (planes_[plane].same_as != plane) continue;
      const auto mark = [&](std::uint32_t p) {
        if (exact_distance(planes_[plane].plane, mesh_.point[p]) != 0) return;
        mesh_.planes_of[p] = mesh_.sets.with(mesh_.planes_of[p], plane);
      };
      if (const Stroke::Facet* facet = planes_.facet(plane))
        for (const std::uint32_t p : points_near_plane(*facet)) mark(p);
      else
        for (std::uint32_t p = 0; p < input_points_; ++p) mark(p);
      if (turned > 1 && is_turned(plane)) find_flush_triangles(plane);
    }
  }

  bool is_turned(int plane) const {
    const glm::dvec3& n = planes_[plane].plane.normal;
    return planes_.facet(plane) == nullptr && std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) < 1;
  }

  /// Boundary triangles that a turned plane runs along, as near as floats can tell, lie in it: what it would slice off
  /// there is thinner than pieces can be, and rounding alone would say where it ends. Planes across an axis cut at
  /// coordinates that are right to the bit, and slice as thinly as they are told.
  void find_flush_triangles(int plane) {
    bool more = mark_flush(plane, 0, flush_);
    // All of a flat face, or nothing: what is next to a flush triangle may lie twice as far away.
    while (more) more = mark_flush(plane, 2, 2 * flush_);
  }

  /// Of triangles that have so many corners in the plane already, those no farther from it than `reach`. False if there
  /// is none with a corner that was not known to lie there.
  bool mark_flush(int plane, int known, double reach) {
    const auto lies_there = [&](std::uint32_t p) { return mesh_.sets.has(mesh_.planes_of[p], plane); };
    const auto is_near = [&](std::uint32_t p) {
      return lies_there(p) || std::fabs(signed_distance(planes_[plane].plane, mesh_.point[p])) <= reach;
    };
    bool found = false;
    for (std::size_t t = 0; t < surfaces_.triangle_count(); ++t) {
      if (!surfaces_.is_boundary(t)) continue;
      const std::array<std::uint32_t, 3> p = welded_corners(t);
      const auto there = std::count_if(p.begin(), p.end(), lies_there);
      if (there < known || there == 3 || !std::all_of(p.begin(), p.end(), is_near) || is_thin(p)) continue;
      for (const std::uint32_t point : p) mesh_.planes_of[point] = mesh_.sets.with(mesh_.planes_of[point], plane);
      found = true;
    }
    return found;
  }

  /// True if it is so narrow that it is near to many planes.
  bool is_thin(const std::array<std::uint32_t, 3>& p) const {
    const glm::dvec3 a = mesh_.point[p[1]] - mesh_.point[p[0]], b = mesh_.point[p[2]] - mesh_.point[p[1]],
                     c = mesh_.point[p[0]] - mesh_.point[p[2]];
    const double longest = std::sqrt(std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)}));
    return glm::length(glm::cross(a, b)) <= 1e3 * flush_ * longest;
  }

  /// Finds normals at points: area-weighted means over the boundary triangles there.
  void find_normals() {
    std::vector<glm::dvec3> sum(mesh_.point.size(), glm::dvec3(0));
    for (const Triangle& t : mesh_.triangle) {
      if (!surfaces_.is_boundary(t.source)) continue;
      const double to_air = surfaces_.is_hidden(t.source, SideOf::front) ? 1 : -1;
      const glm::dvec3 normal = to_air * area_vector(t);
      for (const std::uint32_t v : t.vertex) sum[mesh_.point_of[v]] += normal;
    }
    mesh_.normal.resize(mesh_.point_of.size(), glm::vec3(0));
    for (std::size_t v = 0; v < mesh_.normal.size(); ++v) mesh_.normal[v] = unit(sum[mesh_.point_of[v]]);
  }

  static glm::vec3 unit(const glm::dvec3& v) {
    const double size = glm::length(v);
    return size > 0 ? glm::vec3(v / size) : glm::vec3(0);
  }

  glm::dvec3 area_vector(const Triangle& t) const {
    const glm::dvec3& a = mesh_.place_of(t.vertex[0]);
    return glm::cross(mesh_.place_of(t.vertex[1]) - a, mesh_.place_of(t.vertex[2]) - a);
  }

  void take_plane(int plane) {
    plane_ = plane;
    shared_ = planes_[plane].same_as;
    distance_.resize(mesh_.point.size());
    side_.resize(mesh_.point.size());
    new_points_.clear();
    new_vertices_.clear();
  }

  static bool is_mixed(const std::array<int, 3>& side) {
    return (side[0] < 0 || side[1] < 0 || side[2] < 0) && (side[0] > 0 || side[1] > 0 || side[2] > 0);
  }

  void split_by(int plane) {
    take_plane(plane);
    for (std::uint32_t p = 0; p < mesh_.point.size(); ++p) find_side(p);
    const std::size_t count = mesh_.triangle.size();
    for (std::size_t t = 0; t < count; ++t) {
      const std::array<int, 3> side = sides_of(mesh_.triangle[t]);
      if (is_mixed(side)) {
        split_triangle(t, side);
      } else {
        see_side(mesh_.triangle[t], side[0] + side[1] + side[2]);
      }
    }
  }

  // ---- Strokes ----

  /// Splits by one facet after another. Sides of triangles, and edges that follow the stroke, are found at the end.
  void split_by_stroke(const CutPlanes::Blade& blade) {
    reach_.emplace(mesh_, glm::dvec2(bounds_.low), glm::dvec2(bounds_.high));
    sided_by_.assign(mesh_.point.size(), no_plane);
    for (int i = 0; i < blade.count; ++i) split_by_facet(blade.first + i);
    reach_.reset();
    see_sides_of_stroke(blade);
  }

  /// Triangles that the facet reaches are split along the whole of its plane; their neighbours take over the points
  /// that this puts on common edges, so that triangles go on meeting edge to edge.
  void split_by_facet(int plane) {
    take_plane(plane);
    const Stroke::Facet& facet = *planes_.facet(plane);
    for (const std::uint32_t p : points_near_plane(facet)) find_side_once(p);  // notes those on the plane
    const std::vector<std::uint32_t> near = reach_->near(stretch(facet, near_facet()), near_facet());
    const std::size_t count = mesh_.triangle.size();
    std::vector<std::uint32_t> reached, not_reached;
    for (const std::uint32_t t : near) {
      const std::array<int, 3> side = sides_once(mesh_.triangle[t]);
      if (!is_mixed(side)) continue;
      const bool is_split = is_reached(mesh_.triangle[t], side);
      (is_split ? reached : not_reached).push_back(t);
      if (is_split) split_triangle(t, side);
    }
    const std::vector<std::uint32_t> others = mixed_neighbours(reached, near, count);
    const auto middle = static_cast<std::ptrdiff_t>(not_reached.size());
    not_reached.insert(not_reached.end(), others.begin(), others.end());
    std::inplace_merge(not_reached.begin(), not_reached.begin() + middle, not_reached.end());
    for (const std::uint32_t t : not_reached) take_over_points(t);
  }

  /// Of the first `count` triangles those on both sides of the plane that may be neighbours of `reached` and are not
  /// among `near`.
  std::vector<std::uint32_t> mixed_neighbours(const std::vector<std::uint32_t>& reached,
                                              const std::vector<std::uint32_t>& near, std::size_t count) {
    std::vector<std::uint32_t> others;
    const std::vector<std::uint32_t> around = reach_->neighbours(reached);
    std::set_difference(around.begin(), around.end(), near.begin(), near.end(), std::back_inserter(others));
    std::erase_if(others, [&](std::uint32_t t) { return t >= count || !is_mixed(sides_once(mesh_.triangle[t])); });
    return others;
  }

  /// True if the facet comes near the line in which its plane meets the triangle.
  bool is_reached(const Triangle& t, const std::array<int, 3>& side) const {
    const Stroke::Facet& facet = *planes_.facet(plane_);
    double low = 1e300, high = -1e300;
    const auto see = [&](const glm::dvec3& p) {
      const double along = facet.along_of(glm::dvec2(p));
      low = std::min(low, along);
      high = std::max(high, along);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = next[i];
      const std::uint32_t p = mesh_.point_of[t.vertex[i]], q = mesh_.point_of[t.vertex[j]];
      if (side[i] == 0) see(mesh_.point[p]);
      if (side[i] * side[j] < 0) {
        see(glm::mix(mesh_.point[p], mesh_.point[q], distance_[p] / (distance_[p] + distance_[q])));
      }
    }
    const double margin = 1e4 * planes_.tolerance;
    return high >= facet.from - margin && low <= facet.to + margin;
  }

  void take_over_points(std::size_t index) {
    // Count the edges that the plane passes through, and those on which neighbours have put a point.
    const Triangle whole = mesh_.triangle[index];
    const std::array<int, 3> side = sides_of(whole);
    int crossed = 0, known = 0;
    std::size_t i = 0;
    for (std::size_t e = 0; e < 3; ++e) {
      if (side[e] * side[next[e]] >= 0) continue;
      ++crossed;
      if (!new_points_.contains({mesh_.point_of[whole.vertex[e]], mesh_.point_of[whole.vertex[next[e]]]})) continue;
      ++known;
      i = e;
    }

    // With all of them it is split as its neighbours are; with one of two, from there to the opposite corner.
    if (known == 0) return;
    if (known == crossed) {
      split_triangle(index, side);
      return;
    }
    const std::size_t j = next[i], k = after_next[i];
    const std::uint32_t m = vertex_between(whole.vertex[i], whole.vertex[j]);
    replace(index, whole, {whole.vertex[i], m, whole.vertex[k]}, {whole.cut_by[i], 0, whole.cut_by[k]}, 0);
    add(index, whole, {m, whole.vertex[j], whole.vertex[k]}, {whole.cut_by[i], whole.cut_by[j], 0}, 0);
  }

  /// All edges with both ends on one facet are taken as cut; where both sides are the same they cancel (see
  /// segments.h). So chains close whatever the sides, as long as these change at such edges only.
  void see_sides_of_stroke(const CutPlanes::Blade& blade) {
    const StrokeSides stroke(mesh_, planes_, blade, surfaces_);
    const std::vector<int> side = stroke.of_triangles([&](std::size_t index) {
      const Triangle& t = mesh_.triangle[index];
      plane_ = stroke.facet_nearest_to(mesh_.point_of[t.vertex[0]]);
      return lies_with_positive_side(t);
    });
    for (std::size_t index = 0; index < side.size(); ++index) {
      Triangle& t = mesh_.triangle[index];
      const bool positive = side[index] > 0;
      const CutPlanes::Plane& first = planes_[blade.first];
      t.sides = planes_.knives[static_cast<std::size_t>(first.knife)].seen(t.sides, first.in_knife, positive);
      if (!positive) cut_along_stroke(stroke, t);
    }
  }

  void cut_along_stroke(const StrokeSides& stroke, Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = mesh_.point_of[t.vertex[i]], q = mesh_.point_of[t.vertex[next[i]]];
      const int plane = stroke.facet_with(p, q);
      if (plane < 0) continue;
      t.cut_by[i] = mesh_.sets.with(t.cut_by[i], plane);
      for (const std::uint32_t point : {p, q}) mesh_.planes_of[point] = mesh_.sets.with(mesh_.planes_of[point], plane);
    }
  }

  // ---- What planes and strokes share ----

  /// Exact for the input. Points this plane has made, or found, before lie on it, wherever rounding may have put them.
  /// Planes that coincide see the same sides, but for their sense.
  void find_side(std::uint32_t p) {
    const CuttingPlane& plane = planes_[shared_].plane;
    const int sense = planes_[plane_].turned ? -1 : 1;
    const glm::dvec3& point = mesh_.point[p];
    double distance = p < input_points_ ? exact_distance(plane, point) : signed_distance(plane, point);
    const bool known = mesh_.sets.has(mesh_.planes_of[p], shared_);
    if (known || (p >= input_points_ && std::fabs(distance) <= planes_.rounding)) distance = 0;
    if (!known && distance == 0) mesh_.planes_of[p] = mesh_.sets.with(mesh_.planes_of[p], shared_);
    distance_[p] = std::fabs(distance);
    side_[p] = static_cast<std::int8_t>(distance == 0 ? 0 : (distance > 0) == (sense > 0) ? 1 : -1);
  }

  void find_side_once(std::uint32_t p) {
    if (std::exchange(sided_by_[p], plane_) != plane_) find_side(p);
  }

  std::array<int, 3> sides_once(const Triangle& t) {
    for (const std::uint32_t v : t.vertex) find_side_once(mesh_.point_of[v]);
    return sides_of(t);
  }

  std::array<int, 3> sides_of(const Triangle& t) const {
    const auto side = [&](std::size_t i) { return int{side_[mesh_.point_of[t.vertex[i]]]}; };
    return {side(0), side(1), side(2)};
  }

  /// Notes that the triangle lies on one side. `side` < 0: the negative one; 0: in the plane.
  void see_side(Triangle& t, int side) {
    if (reach_) return;
    const bool positive = side > 0 || (side == 0 && lies_with_positive_side(t));
    t.sides = planes_.knives[static_cast<std::size_t>(planes_[plane_].knife)].seen(t.sides, planes_[plane_].in_knife,
                                                                                   positive);
    if (positive || shared_ != plane_) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool on_plane = side_[mesh_.point_of[t.vertex[i]]] == 0 && side_[mesh_.point_of[t.vertex[next[i]]]] == 0;
      if (!on_plane) continue;
      // Inner sheets bound nothing: along the axis all faces that meet there see them.
      t.cut_by[i] = surfaces_.is_boundary(t.source) ? mesh_.sets.with_alone(t.cut_by[i], plane_)
                                                    : mesh_.sets.with(t.cut_by[i], plane_);
    }
  }

  /// True if a triangle in the plane goes with the solid that it bounds on the positive side. So no piece is a mere
  /// film. Inner triangles are positive.
  bool lies_with_positive_side(const Triangle& t) const {
    if (!surfaces_.is_boundary(t.source)) return true;
    const double front_up = glm::dot(area_vector(t), planes_[plane_].plane.normal);
    return surfaces_.is_hidden(t.source, SideOf::front) ? front_up < 0 : front_up > 0;
  }

  void split_triangle(std::size_t index, const std::array<int, 3>& side) {
    // Turn it so that the corner alone on its side, or on the plane, comes first.
    const Triangle whole = mesh_.triangle[index];
    std::size_t first = 0;
    while (!(side[first] == 0 || (side[next[first]] == side[after_next[first]]))) ++first;
    for (std::size_t i = 0; i < 3; ++i) {
      if (side[i] == 0) first = i;
    }
    const std::size_t second = next[first], third = after_next[first];
    const std::uint32_t a = whole.vertex[first], b = whole.vertex[second], c = whole.vertex[third];
    const std::uint32_t ab = whole.cut_by[first], bc = whole.cut_by[second], ca = whole.cut_by[third];

    if (side[first] == 0) {
      const std::uint32_t m = vertex_between(b, c);
      replace(index, whole, {a, b, m}, {ab, bc, 0}, side[second]);
      add(index, whole, {a, m, c}, {0, bc, ca}, side[third]);
      return;
    }

    // Split it into the corner's triangle and two of the rest, along the shorter diagonal.
    const std::uint32_t p = vertex_between(a, b), q = vertex_between(a, c);
    replace(index, whole, {a, p, q}, {ab, 0, ca}, side[first]);
    const glm::dvec3 from_p = mesh_.place_of(c) - mesh_.place_of(p), from_q = mesh_.place_of(b) - mesh_.place_of(q);
    if (glm::dot(from_p, from_p) <= glm::dot(from_q, from_q)) {
      add(index, whole, {p, b, c}, {ab, bc, 0}, side[second]);
      add(index, whole, {p, c, q}, {0, ca, 0}, side[second]);
    } else {
      add(index, whole, {p, b, q}, {ab, 0, 0}, side[second]);
      add(index, whole, {b, c, q}, {bc, ca, 0}, side[second]);
    }
  }

  void replace(std::size_t index, const Triangle& whole, const std::array<std::uint32_t, 3>& vertex,
               const std::array<std::uint32_t, 3>& cut_by, int side) {
    Triangle part = whole;
    part.vertex = vertex;
    part.cut_by = cut_by;
    see_side(part, side);
    mesh_.triangle[index] = part;
  }

  /// Adds a part of the triangle at `index`, which was `whole`.
  void add(std::size_t index, const Triangle& whole, const std::array<std::uint32_t, 3>& vertex,
           const std::array<std::uint32_t, 3>& cut_by, int side) {
    mesh_.triangle.emplace_back();
    if (reach_) reach_->add_part_of(static_cast<std::uint32_t>(index));
    replace(mesh_.triangle.size() - 1, whole, vertex, cut_by, side);
  }

  /// The vertex where the plane meets the edge, the same for all triangles at the edge.
  std::uint32_t vertex_between(std::uint32_t a, std::uint32_t b) {
    if (mesh_.point_of[a] > mesh_.point_of[b]) std::swap(a, b);
    const auto [vertex, is_new] = new_vertices_.try_emplace({a, b}, mesh_.point_of.size());
    if (!is_new) return vertex;

    const std::uint32_t p = mesh_.point_of[a], q = mesh_.point_of[b];
    const double t = distance_[p] / (distance_[p] + distance_[q]);
    const auto share = static_cast<float>(t);
    const Color front = glm::mix(mesh_.front_color[a], mesh_.front_color[b], share),
                back = glm::mix(mesh_.back_color[a], mesh_.back_color[b], share);
    const glm::vec3 to_air = unit(glm::mix(glm::dvec3(mesh_.normal[a]), glm::dvec3(mesh_.normal[b]), t));
    return mesh_.add_vertex(point_between(p, q, t), front, back, to_air);
  }

  std::uint32_t point_between(std::uint32_t p, std::uint32_t q, double t) {
    const auto [point, is_new] = new_points_.try_emplace({p, q}, mesh_.point.size());
    if (!is_new) return point;

    // The new point lies on this plane, and on all planes that both ends lie on.
    const std::uint32_t set = mesh_.sets.with(mesh_.sets.common(mesh_.planes_of[p], mesh_.planes_of[q]), shared_);
    mesh_.add_point(snapped_to_planes(glm::mix(mesh_.point[p], mesh_.point[q], t), mesh_.sets.planes_in(set), planes_),
                    set);
    distance_.push_back(0);
    side_.push_back(0);
    if (flat_points_) flat_points_->add(point, glm::dvec2(mesh_.point.back()));
    if (reach_) sided_by_.push_back(plane_);
    return point;
  }

  const DiffusionSurfaces& surfaces_;
  const CutPlanes& planes_;
  SplitMesh mesh_;

  // The plane at work, the one it coincides with, and where points lie to it.
  int plane_ = 0, shared_ = 0;
  std::size_t input_points_ = 0;
  double flush_ = 0;
  std::vector<double> distance_;  // without sign
  std::vector<std::int8_t> side_;
  static constexpr int no_plane = -1;
  std::vector<int> sided_by_;  // per point: the facet to which its side was found last
  Box<double> bounds_;         // of the input, if there are strokes
  std::optional<FlatGrid> flat_points_;
  std::optional<StrokeReach> reach_;  // while a stroke splits
  EdgeMap<std::uint32_t> new_points_, new_vertices_;
};

}  // namespace

SplitMesh split(const DiffusionSurfaces& surfaces, const CutPlanes& planes) {
  return Splitter(surfaces, planes).split();
}

}  // namespace pomona
