#include "generator/piece/lod/collapse_rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {
namespace {

/// Normals more than 30 degrees apart make a border: an edge in the shading stays one.
constexpr float crease_cosine = 0.866f;

/// Two colours at one place make a border if a channel differs by more than this, of the square root of light.
constexpr double min_jump = 0.012;

/// A triangle may turn by 60 degrees in one collapse, and by 80 from the triangle it grew from.
constexpr double min_cosine_now = 0.5, min_cosine_ever = 0.17;

/// A triangle that has not turned still lies in its original face.
constexpr double flat_cosine = 1 - 1e-12;

/// Twice the area over the square of the longest edge; 0.87 if all sides are equal. Narrower triangles shade badly.
constexpr double narrowest = 0.03;

/// The cost of long edges beside squared distances: enough to prefer short ones if all else is equal, as on a plane.
constexpr double cost_of_length = 1e-3;

/// The share of the bound for tested points; the rest is for places between them.
constexpr double share_for_points = 0.75;

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

glm::dvec3 area_vector(const TriangleCorners& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

double roundness(const TriangleCorners& t) {
  const double longest = std::max({squared(t[1] - t[0]), squared(t[2] - t[1]), squared(t[0] - t[2])});
  return longest > 0 ? glm::length(area_vector(t)) / longest : 0;
}

/// True if the angle between two vectors has more than this cosine.
bool is_within(const glm::dvec3& a, const glm::dvec3& b, double cosine) {
  return glm::dot(a, b) > cosine * std::sqrt(squared(a) * squared(b));
}

/// Nearly uniform to the eye, and without a function that differs between processors.
glm::dvec3 seen(const glm::dvec3& linear) { return glm::sqrt(glm::max(linear, glm::dvec3(0))); }

double greatest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double squared_distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double length = squared(along);
  const double share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
  return squared(p - (a + along * share));
}

/// The place of a face between two neighbours, all counted around the ring.
std::size_t before(std::size_t i, std::size_t count) { return (i + count - 1) % count; }

}  // namespace

CollapseRules::CollapseRules(const Solid& solid, const VertexFans& fans)
    : mesh_(solid.mesh), source_(fans.source), area_(fans.vertex.size(), 0.0) {
  for (const std::uint32_t vertex : fans.vertex) position_.emplace_back(solid.mesh.position[vertex]);
  for (const Color& color : solid.mesh.color) seen_.push_back(seen(glm::dvec3(color)));
  for (std::size_t f = 0; f < fans.triangle.size(); ++f) {
    CornerFace face;
    for (int i = 0; i < 3; ++i) {
      face.fan[static_cast<std::size_t>(i)] = fans.triangle[f][i];
      face.vertex[static_cast<std::size_t>(i)] = solid.mesh.triangle[fans.source[f]][i];
    }
    normal_.push_back(area_vector({position_[face.fan[0]], position_[face.fan[1]], position_[face.fan[2]]}));
    for (const std::uint32_t fan : face.fan) area_[fan] += glm::length(normal_.back()) / 6;
    face_.push_back(std::move(face));
  }
  faces_left_ = face_.size();
  plant_trees();
}

/// Level and solid are compared for each cut face and each surface separately.
void CollapseRules::plant_trees() {
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<glm::uvec3>> patches;
  for (std::size_t t = 0; t < mesh_.triangle.size(); ++t)
    patches[{mesh_.cut_face[t], mesh_.surface[t]}].push_back(mesh_.triangle[t]);
  std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t> number;
  for (const auto& [patch, triangles] : patches) {
    number[patch] = static_cast<std::uint32_t>(trees_.size());
    trees_.emplace_back(mesh_.position, triangles);
  }
  for (const std::uint32_t t : source_) tree_of_.push_back(number.at({mesh_.cut_face[t], mesh_.surface[t]}));
}

std::uint32_t CollapseRules::vertex_at(std::uint32_t face, std::uint32_t fan) const {
  const CornerFace& f = face_[face];
  return f.vertex[f.fan[0] == fan ? 0 : f.fan[1] == fan ? 1 : 2];
}

bool CollapseRules::looks_alike(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return true;
  if (mesh_.part[a] != mesh_.part[b]) return false;
  return greatest(seen_[a] - seen_[b]) < min_jump && glm::dot(mesh_.normal[a], mesh_.normal[b]) > crease_cosine;
}

bool CollapseRules::is_border(std::int32_t left, std::int32_t right, std::uint32_t from, std::uint32_t to) const {
  if (left < 0 || right < 0) return true;
  const auto l = static_cast<std::uint32_t>(left), r = static_cast<std::uint32_t>(right);
  if (mesh_.cut_face[source_[l]] != mesh_.cut_face[source_[r]]) return true;
  if (mesh_.surface[source_[l]] != mesh_.surface[source_[r]]) return true;
  return !looks_alike(vertex_at(l, from), vertex_at(r, from)) || !looks_alike(vertex_at(l, to), vertex_at(r, to));
}

std::optional<CollapseRules::Change> CollapseRules::change_by(const CollapseRing& ring) const {
  // The vertex has no border, or two border edges, one of which leads to its target.
  const std::size_t count = ring.spoke.size();
  std::vector<std::size_t> borders;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_border(ring.face[before(i, count)], ring.face[i], ring.removed, ring.spoke[i])) borders.push_back(i);
  }
  Change change;
  if (borders.empty()) {
    if (!add_sector(ring, 0, count, change)) return std::nullopt;
    return change;
  }
  if (borders.size() != 2 || borders[0] != 0) return std::nullopt;

  // The faces to the left of the border and those to its right.
  change.border_end = ring.spoke[borders[1]];
  if (!add_sector(ring, 0, borders[1], change) || !add_sector(ring, borders[1], count, change)) return std::nullopt;
  return change;
}

/// False if all faces of a sector would vanish, or if the vertex would change its part.
bool CollapseRules::add_sector(const CollapseRing& ring, std::size_t first, std::size_t last, Change& change) const {
  Sector sector;
  for (std::size_t i = first; i < last; ++i) {
    if (ring.face[i] < 0) continue;
    const bool is_beside = i == 0 || i + 1 == ring.face.size();
    (is_beside ? sector.lost : sector.kept).push_back(static_cast<std::uint32_t>(ring.face[i]));
  }
  if (sector.kept.empty() && sector.lost.empty()) return true;
  if (sector.kept.empty() || sector.lost.empty()) return false;
  sector.from = vertex_at(sector.lost.front(), ring.removed);
  sector.to = vertex_at(sector.lost.front(), ring.spoke[0]);
  const bool same_part = mesh_.part[sector.from] == mesh_.part[sector.to];
  change.sectors.push_back(std::move(sector));
  return same_part;
}

std::vector<CollapseRules::Target> CollapseRules::targets_of(const CollapseRing& ring, const Sector& sector) const {
  std::vector<Target> targets(sector.kept.size());
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const CornerFace& face = face_[sector.kept[k]];
    for (std::size_t i = 0; i < 3; ++i) {
      const bool moves = face.fan[i] == ring.removed;
      targets[k].corner[i] = position_[moves ? ring.spoke[0] : face.fan[i]];
      targets[k].vertex[i] = moves ? sector.to : face.vertex[i];
    }
  }
  return targets;
}

std::vector<CollapseRules::Removed> CollapseRules::removed_in(const CollapseRing& ring, const Sector& sector) const {
  std::vector<Removed> all{{sector.from, ring.removed}};
  for (const std::vector<std::uint32_t>* faces : {&sector.kept, &sector.lost}) {
    for (const std::uint32_t face : *faces)
      all.insert(all.end(), face_[face].removed.begin(), face_[face].removed.end());
  }
  return all;
}

std::optional<double> CollapseRules::cost(const CollapseRing& ring, double limit) const {
  // Stops when the cost is above the limit.
  double sum = cost_of_length * area_[ring.removed] * squared(position_[ring.removed] - position_[ring.spoke[0]]);
  if (!(sum < limit)) return std::nullopt;
  const std::optional<Change> change = change_by(ring);
  if (!change) return std::nullopt;
  if (change->border_end) {
    const std::optional<double> border = cost_of_border(ring, *change);
    if (!border) return std::nullopt;
    sum += *border;
  }
  for (const Sector& sector : change->sectors) {
    const std::optional<double> cost = cost_of_sector(ring, sector, limit - sum);
    if (!cost) return std::nullopt;
    sum += *cost;
  }
  return sum;
}

std::vector<std::uint32_t> CollapseRules::gone_from_border(const CollapseRing& ring, const Change& change) const {
  std::vector<std::uint32_t> gone{ring.removed};
  for (const std::uint32_t end : {ring.spoke[0], *change.border_end}) {
    const std::vector<std::uint32_t>* known = gone_from_.find({ring.removed, end});
    if (known) gone.insert(gone.end(), known->begin(), known->end());
  }
  return gone;
}

/// The change of the border, from its other neighbour straight to the vertex's target.
std::optional<double> CollapseRules::cost_of_border(const CollapseRing& ring, const Change& change) const {
  const glm::dvec3 &from = position_[*change.border_end], &to = position_[ring.spoke[0]];
  double sum = 0;
  for (const std::uint32_t fan : gone_from_border(ring, change)) {
    const double distance = squared_distance_to_segment(position_[fan], from, to);
    if (distance > bound() * bound()) return std::nullopt;
    sum += area_[fan] * distance;
  }
  return sum;
}

std::optional<double> CollapseRules::cost_of_sector(const CollapseRing& ring, const Sector& sector,
                                                    double limit) const {
  const std::vector<Target> targets = targets_of(ring, sector);
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (!keeps_its_side(sector.kept[k], targets[k])) return std::nullopt;
  }
  double sum = 0;
  for (const Removed& removed : removed_in(ring, sector)) {
    const std::optional<double> cost = cost_of_removed(removed, targets);
    if (!cost || !(sum + *cost < limit)) return std::nullopt;
    sum += *cost;
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (!lies_near(sector.kept[k], targets[k])) return std::nullopt;
  }
  return sum;
}

/// The other direction: whether the triangle is near the solid, and does not leap over a hollow or cut off a ridge.
/// Only surface that faces as it does counts: the far side of a thin leaf does not.
bool CollapseRules::lies_near(std::uint32_t face, const Target& target) const {
  const TriangleCorners& c = target.corner;
  const glm::dvec3 normal = area_vector(c);
  if (is_within(normal, normal_[face], flat_cosine)) return true;
  const TriangleTree& tree = trees_[tree_of_[face]];
  const glm::dvec3 middle = (c[0] + c[1] + c[2]) / 3.0;
  const std::array<glm::dvec3, 7> points{middle,
                                         0.5 * (c[0] + c[1]),
                                         0.5 * (c[1] + c[2]),
                                         0.5 * (c[2] + c[0]),
                                         0.5 * (middle + c[0]),
                                         0.5 * (middle + c[1]),
                                         0.5 * (middle + c[2])};
  return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
    return tree.nearest_facing(point, normal, bound()).distance <= bound();
  });
}

/// False if the triangle would turn over, or become a needle that it was not before.
bool CollapseRules::keeps_its_side(std::uint32_t face, const Target& target) const {
  const CornerFace& f = face_[face];
  const TriangleCorners now{position_[f.fan[0]], position_[f.fan[1]], position_[f.fan[2]]};
  const glm::dvec3 normal = area_vector(target.corner), normal_now = area_vector(now);
  if (!(squared(normal) > 0)) return false;
  if (squared(normal_now) > 0 && !is_within(normal, normal_now, min_cosine_now)) return false;
  if (squared(normal_[face]) > 0 && !is_within(normal, normal_[face], min_cosine_ever)) return false;
  const double round = roundness(target.corner);
  return round > narrowest || round >= roundness(now);
}

double CollapseRules::bound() const { return share_for_points * bounds_.distance; }

glm::dvec3 CollapseRules::color_on(const Target& target, const glm::dvec3& point) const {
  const glm::dvec3 normal = area_vector(target.corner);
  const double whole = squared(normal);
  glm::dvec3 color(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = target.corner[(i + 1) % 3], &b = target.corner[(i + 2) % 3];
    const double share = glm::dot(glm::cross(a - point, b - point), normal) / whole;
    color += share * glm::dvec3(mesh_.color[target.vertex[i]]);
  }
  return color;
}

CollapseRules::Nearest CollapseRules::nearest_target(const Removed& removed, const std::vector<Target>& targets) const {
  Nearest nearest;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const glm::dvec3 point = nearest_on_triangle(position_[removed.fan], targets[k].corner);
    const double distance = squared(point - position_[removed.fan]);
    if (distance < nearest.squared_distance) nearest = {k, point, distance};
  }
  return nearest;
}

/// How well the level represents a removed vertex: its place, its colour, and its direction.
std::optional<double> CollapseRules::cost_of_removed(const Removed& removed, const std::vector<Target>& targets) const {
  const Nearest nearest = nearest_target(removed, targets);
  const Target& target = targets[nearest.target];
  if (nearest.squared_distance > bound() * bound()) return std::nullopt;
  if (glm::dot(area_vector(target.corner), glm::dvec3(mesh_.normal[removed.vertex])) < 0) return std::nullopt;

  const glm::dvec3 difference = seen(color_on(target, nearest.point)) - seen_[removed.vertex];
  if (greatest(difference) > bounds_.color) return std::nullopt;
  const double metres_per_color = bounds_.distance / bounds_.color;
  return area_[removed.fan] * metres_per_color * metres_per_color * squared(difference);
}

void CollapseRules::collapse(const CollapseRing& ring) {
  // At a border two edges become one, which takes the fans along both.
  const std::optional<Change> change = change_by(ring);
  if (!change) return;
  if (change->border_end) {
    std::vector<std::uint32_t> gone = gone_from_border(ring, *change);
    for (const std::uint32_t end : {ring.spoke[0], *change->border_end}) gone_from_.erase({ring.removed, end});
    gone_from_[{ring.spoke[0], *change->border_end}] = std::move(gone);
  }
  for (const Sector& sector : change->sectors) {
    // Finds the changes of faces, and the vertices that they take over, before any changes.
    const std::vector<Target> targets = targets_of(ring, sector);
    const std::vector<Removed> removed = removed_in(ring, sector);

    // Some faces vanish, the others change to the other vertex, and each takes over the removed vertices nearest to it.
    for (const std::uint32_t face : sector.lost) {
      face_[face].is_there = false;
      face_[face].removed.clear();
      --faces_left_;
    }
    for (std::size_t k = 0; k < targets.size(); ++k) {
      CornerFace& face = face_[sector.kept[k]];
      face.removed.clear();
      face.vertex = targets[k].vertex;
      std::replace(face.fan.begin(), face.fan.end(), ring.removed, ring.spoke[0]);
    }
    for (const Removed& one : removed) face_[sector.kept[nearest_target(one, targets).target]].removed.push_back(one);
  }
}

std::vector<CollapseRules::Face> CollapseRules::faces() const {
  std::vector<Face> left;
  for (std::size_t f = 0; f < face_.size(); ++f) {
    const auto& v = face_[f].vertex;
    if (face_[f].is_there) left.push_back({source_[f], {v[0], v[1], v[2]}});
  }
  return left;
}

}  // namespace pomona
