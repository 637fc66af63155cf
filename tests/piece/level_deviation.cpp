#include "tests/piece/level_deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

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

/// The triangles of one cut face or surface, which finds the nearest of them.
class Patch {
 public:
  void add(const ColoredTriangle& triangle) { triangles_.push_back(triangle); }

  /// The nearest triangle that faces the same way, or of all triangles if `normal` is 0. The search begins at the last
  /// result.
  Near nearest(const glm::dvec3& point, const glm::dvec3& normal = glm::dvec3(0)) {
    double min = std::numeric_limits<double>::infinity();
    glm::dvec3 at(0);
    const auto look_at = [&](std::size_t i) {
      const ColoredTriangle& triangle = triangles_[i];
      const double reach = min + triangle.radius;
      const glm::dvec3 away = point - triangle.middle;
      if (glm::dot(away, away) > reach * reach || glm::dot(triangle.normal, normal) < 0) return;
      const glm::dvec3 on = nearest_on_triangle(point, triangle.corner);
      const double distance = glm::distance(on, point);
      if (distance < min) min = distance, at = on, last_ = i;
    };
    look_at(last_);
    for (std::size_t i = 0; i < triangles_.size(); ++i) look_at(i);
    return {min, color_at(triangles_[last_], at)};
  }

 private:
  std::vector<ColoredTriangle> triangles_;
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
