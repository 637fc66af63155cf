#include "generator/surface/grains/grain_walls.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "generator/mesh/triangle_distance.h"

namespace pomona {

namespace {

std::vector<Enclosures::Triangle> triangles_of(const std::vector<SweptGrid>& meshes) {
  std::vector<Enclosures::Triangle> triangles;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    for (const glm::uvec3& t : meshes[m].triangle) {
      const auto& p = meshes[m].position;
      triangles.push_back({{p[t.x], p[t.y], p[t.z]}, static_cast<std::uint32_t>(m)});
    }
  }
  return triangles;
}

/// Maps to the space in which the body is the unit ball, and back. The half axes are at right angles.
class BallSpace {
 public:
  explicit BallSpace(const GrainBody& body)
      : body_(body),
        thickness_(body.pose.thickness / glm::dot(body.pose.thickness, body.pose.thickness)),
        length_(body.pose.length / glm::dot(body.pose.length, body.pose.length)),
        width_(body.pose.width / glm::dot(body.pose.width, body.pose.width)) {}

  glm::dvec3 to(const glm::dvec3& place) const {
    const glm::dvec3 p = place - body_.center;
    return {glm::dot(p, thickness_), glm::dot(p, length_), glm::dot(p, width_)};
  }
  /// Maps a difference back.
  glm::dvec3 from(const glm::dvec3& p) const {
    return body_.pose.thickness * p.x + body_.pose.length * p.y + body_.pose.width * p.z;
  }

 private:
  const GrainBody& body_;
  glm::dvec3 thickness_, length_, width_;
};

/// The half size of the box around the body.
glm::dvec3 reach_of(const GrainPose& pose) {
  return glm::sqrt(pose.thickness * pose.thickness + pose.length * pose.length + pose.width * pose.width);
}

}  // namespace

GrainWalls::GrainWalls(const std::vector<SweptGrid>& meshes, double cell)
    : cell_(cell), triangles_(triangles_of(meshes)), enclosures_(triangles_) {
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const auto& [a, b, c] = triangles_[i].corner;
    const Cell low = cell_of(glm::min(a, glm::min(b, c))), high = cell_of(glm::max(a, glm::max(b, c)));
    for (std::int32_t x = low.x; x <= high.x; ++x)
      for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t z = low.z; z <= high.z; ++z) over_.emplace_back(Cell{x, y, z}, i);
  }
  std::sort(over_.begin(), over_.end());
}

GrainWalls::Cell GrainWalls::cell_of(const glm::dvec3& place) const {
  const auto at = [&](double coordinate) { return static_cast<std::int32_t>(std::floor(coordinate / cell_)); };
  return {at(place.x), at(place.y), at(place.z)};
}

template <typename Visit>
void GrainWalls::for_each_near(const glm::dvec3& low, const glm::dvec3& high, const Visit& visit) const {
  const Cell from = cell_of(low), to = cell_of(high);
  for (std::int32_t x = from.x; x <= to.x; ++x) {
    for (std::int32_t y = from.y; y <= to.y; ++y) {
      // Cells that follow each other along z lie one after the other.
      auto entry = std::lower_bound(over_.begin(), over_.end(), std::pair(Cell{x, y, from.z}, 0u));
      for (; entry != over_.end() && entry->first <= Cell{x, y, to.z}; ++entry) visit(entry->second);
    }
  }
}

std::vector<std::uint32_t> GrainWalls::around(const glm::dvec3& place) const {
  std::vector<std::uint32_t> meshes;
  for (const auto& [mesh, winding] : enclosures_.around(place)) meshes.push_back(mesh);
  return meshes;
}

WallPush GrainWalls::deepest(const GrainBody& body, const std::vector<std::uint32_t>& home) const {
  // Of each mesh the nearest place, in the body's own space. A mesh on whose wrong side the centre lies is in the way
  // however far its wall is.
  const std::vector<std::uint32_t> here = around(body.center);
  std::vector<std::uint32_t> wrong;
  std::set_symmetric_difference(here.begin(), here.end(), home.begin(), home.end(), std::back_inserter(wrong));
  const BallSpace ball(body);
  double reach = 1;
  const glm::dvec3 box = reach_of(body.pose);
  std::map<std::uint32_t, glm::dvec3> nearest;
  const auto look = [&](std::uint32_t triangle) {
    const Enclosures::Triangle& t = triangles_[triangle];
    const glm::dvec3 low = glm::min(t.corner[0], glm::min(t.corner[1], t.corner[2]));
    const glm::dvec3 high = glm::max(t.corner[0], glm::max(t.corner[1], t.corner[2]));
    if (glm::any(glm::lessThan(high, body.center - reach * box)) ||
        glm::any(glm::greaterThan(low, body.center + reach * box)))
      return;
    const TriangleCorners corners{ball.to(t.corner[0]), ball.to(t.corner[1]), ball.to(t.corner[2])};
    const glm::dvec3 place = nearest_on_triangle(glm::dvec3(0), corners);
    const auto [known, is_new] = nearest.emplace(t.mesh, place);
    if (!is_new && glm::dot(place, place) < glm::dot(known->second, known->second)) known->second = place;
  };
  for (; reach < 9; reach *= 2) {
    for_each_near(body.center - reach * box, body.center + reach * box, look);
    const bool found = std::all_of(wrong.begin(), wrong.end(), [&](std::uint32_t m) { return nearest.contains(m); });
    if (found) break;
  }

  WallPush worst;
  for (const auto& [mesh, place] : nearest) {
    const bool is_wrong = std::binary_search(wrong.begin(), wrong.end(), mesh);
    const double away = glm::length(place), depth = is_wrong ? 1 + away : 1 - away;
    if (depth <= worst.depth || !(away > 0)) continue;
    worst.depth = depth;
    worst.by = ball.from(place * ((is_wrong ? 1 : -1) * depth / away));
  }
  return worst;
}

}  // namespace pomona
