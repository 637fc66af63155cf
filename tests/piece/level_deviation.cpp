#include "tests/piece/level_deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"

namespace pomona {
namespace {

struct ColoredTriangle {
  TriangleCorners corner;
  std::array<glm::dvec3, 3> color;
  glm::dvec3 middle{0}, normal{0};  ///< the normal is as long as twice the area
  double radius = 0;                ///< around the middle
};

ColoredTriangle triangle_of(const Solid& solid, std::size_t t) {
  ColoredTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = solid.mesh.triangle[t][static_cast<int>(i)];
    triangle.corner[i] = glm::dvec3(solid.mesh.position[v]);
    triangle.color[i] = glm::dvec3(solid.mesh.color[v]);
  }
  const auto& c = triangle.corner;
  triangle.middle = (c[0] + c[1] + c[2]) / 3.0;
  triangle.normal = glm::cross(c[1] - c[0], c[2] - c[0]);
  for (const glm::dvec3& corner : c)
    triangle.radius = std::max(triangle.radius, glm::distance(corner, triangle.middle));
  return triangle;
}

/// Triangles so narrow that rounding may turn them. Their corners belong to other triangles, too.
bool is_needle(const ColoredTriangle& t) { return glm::length(t.normal) < 1e-3 * t.radius * t.radius; }

glm::dvec3 color_at(const ColoredTriangle& t, const glm::dvec3& point) {
  const double whole = glm::dot(t.normal, t.normal);
  if (!(whole > 0)) return t.color[0];
  glm::dvec3 color(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 opposite = glm::cross(t.corner[(i + 1) % 3] - point, t.corner[(i + 2) % 3] - point);
    color += glm::dot(opposite, t.normal) / whole * t.color[i];
  }
  return color;
}

struct Near {
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec3 color{0};
};

/// Triangles of one cut face or surface, beside each other, within a ball.
struct Cluster {
  std::size_t first = 0, last = 0;  ///< of the triangles
  std::size_t far = 0;              ///< the number of its second half; its first half follows it; 0: it is not halved
  glm::dvec3 middle{0};
  double radius = 0;
};

/// The triangles of one cut face or surface, which finds the nearest of them.
class Patch {
 public:
  void add(const ColoredTriangle& triangle) { triangles_.push_back(triangle); }

  /// The nearest triangle that faces the same way, or of all triangles if `normal` is 0. The search begins at the last
  /// result.
  Near nearest(const glm::dvec3& point, const glm::dvec3& normal = glm::dvec3(0)) {
    if (clusters_.empty()) halve(0, triangles_.size());
    Search search{.point = point, .normal = normal, .min = std::numeric_limits<double>::infinity(), .at = {}};
    look_at(search, last_);
    look_into(search, 0);
    return {search.min, color_at(triangles_[last_], search.at)};
  }

 private:
  struct Search {
    glm::dvec3 point, normal;
    double min;
    glm::dvec3 at;
  };

  static bool is_beyond(const Search& search, const glm::dvec3& middle, double radius) {
    const double reach = search.min + radius;
    const glm::dvec3 away = search.point - middle;
    return glm::dot(away, away) > reach * reach;
  }

  void look_at(Search& search, std::size_t i) {
    const ColoredTriangle& triangle = triangles_[i];
    if (is_beyond(search, triangle.middle, triangle.radius) || glm::dot(triangle.normal, search.normal) < 0) return;
    const glm::dvec3 on = nearest_on_triangle(search.point, triangle.corner);
    const double distance = glm::distance(on, search.point);
    if (distance < search.min) search.min = distance, search.at = on, last_ = i;
  }

  void look_into(Search& search, std::size_t c) {
    const Cluster& cluster = clusters_[c];
    if (is_beyond(search, cluster.middle, cluster.radius)) return;
    if (cluster.far == 0) {
      for (std::size_t i = cluster.first; i < cluster.last; ++i) look_at(search, i);
      return;
    }
    const auto distance = [&](std::size_t half) { return glm::distance(search.point, clusters_[half].middle); };
    const bool is_far_first = distance(cluster.far) < distance(c + 1);
    look_into(search, is_far_first ? cluster.far : c + 1);
    look_into(search, is_far_first ? c + 1 : cluster.far);
  }

  /// Along the longest side of the box around the middles, down to eight triangles.
  void halve(std::size_t first, std::size_t last) {
    const std::size_t c = clusters_.size();
    glm::dvec3 low = triangles_[first].middle, high = low;
    for (std::size_t i = first; i < last; ++i)
      low = glm::min(low, triangles_[i].middle), high = glm::max(high, triangles_[i].middle);
    Cluster cluster{.first = first, .last = last, .middle = 0.5 * (low + high)};
    for (std::size_t i = first; i < last; ++i) {
      const double reach = glm::distance(cluster.middle, triangles_[i].middle) + triangles_[i].radius;
      cluster.radius = std::max(cluster.radius, reach);
    }
    clusters_.push_back(cluster);
    if (last - first <= 8) return;
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(half), at(last), [&](const ColoredTriangle& a, const ColoredTriangle& b) {
      return a.middle[axis] < b.middle[axis];
    });
    halve(first, half);
    clusters_[c].far = clusters_.size();
    halve(half, last);
  }

  std::vector<ColoredTriangle> triangles_;
  std::vector<Cluster> clusters_;
  std::size_t last_ = 0;
};

using Patches = std::map<std::pair<std::int32_t, std::int32_t>, Patch>;

Patches patches_of(const Solid& solid) {
  Patches patches;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t)
    patches[{solid.mesh.cut_face[t], solid.mesh.surface[t]}].add(triangle_of(solid, t));
  return patches;
}

/// From the solid to the level: the solid's vertices and the middles of its triangles.
double farthest_from(const Solid& solid, Patches& level) {
  double farthest = 0;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const ColoredTriangle triangle = triangle_of(solid, t);
    if (is_needle(triangle)) continue;
    const auto patch = level.find({solid.mesh.cut_face[t], solid.mesh.surface[t]});
    if (patch == level.end()) return std::numeric_limits<double>::infinity();
    for (const glm::dvec3& point : {triangle.corner[0], triangle.corner[1], triangle.corner[2], triangle.middle})
      farthest = std::max(farthest, patch->second.nearest(point).distance);
  }
  return farthest;
}

double squared_srgb_error(const glm::dvec3& a, const glm::dvec3& b) {
  const auto srgb = [](double linear) { return 255 * srgb_from_linear(std::clamp(linear, 0.0, 1.0)); };
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += (srgb(a[i]) - srgb(b[i])) * (srgb(a[i]) - srgb(b[i])) / 3;
  return sum;
}

}  // namespace

LevelDeviation deviation(const Solid& level, const Solid& solid, double spacing) {
  LevelDeviation found;
  Patches of_level = patches_of(level), of_solid = patches_of(solid);
  found.distance = farthest_from(solid, of_level);

  // From the level to the solid: points evenly over its triangles.
  double color_sum = 0, area_sum = 0;
  for (std::size_t t = 0; t < level.mesh.triangle.size(); ++t) {
    const ColoredTriangle triangle = triangle_of(level, t);
    if (is_needle(triangle)) continue;
    Patch& patch = of_solid.at({level.mesh.cut_face[t], level.mesh.surface[t]});
    const double area = glm::length(triangle.normal) / 2;
    const int steps = std::clamp(static_cast<int>(std::ceil(std::sqrt(2 * area) / spacing)), 1, 32);
    const double share = area / (0.5 * steps * (steps + 1));
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; i + j < steps; ++j) {
        const double x = (i + 1.0 / 3) / steps, y = (j + 1.0 / 3) / steps;
        const auto& c = triangle.corner;
        const glm::dvec3 point = c[0] + (c[1] - c[0]) * x + (c[2] - c[0]) * y;
        const Near near = patch.nearest(point, triangle.normal);
        found.distance = std::max(found.distance, near.distance);
        color_sum += share * squared_srgb_error(color_at(triangle, point), near.color);
        area_sum += share;
      }
    }
  }
  found.color_rms = area_sum > 0 ? std::sqrt(color_sum / area_sum) : 0;
  return found;
}

}  // namespace pomona
