#include "tests/diffusion/brute_force_pmvc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/units.h"

namespace pomona {

namespace {

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t triangle = 0;
  glm::dvec3 barycentric{0};
  bool is_front = false;
};

/// Möller & Trumbore 1997.
std::optional<Hit> hit_triangle(const DiffusionSurfaces& surfaces, std::size_t triangle, const glm::dvec3& origin,
                                const glm::dvec3& direction) {
  const glm::uvec3& t = surfaces.triangle[triangle];
  const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
  const glm::dvec3 p = glm::cross(direction, c - a);
  const double determinant = glm::dot(b - a, p);
  if (determinant == 0) return {};
  const double second = glm::dot(origin - a, p) / determinant;
  const glm::dvec3 q = glm::cross(origin - a, b - a);
  const double third = glm::dot(direction, q) / determinant;
  const double distance = glm::dot(c - a, q) / determinant;
  if (second < 0 || third < 0 || second + third > 1 || distance <= 0) return {};
  return Hit{distance, triangle, {1 - second - third, second, third}, determinant > 0};
}

Hit first_hit(const DiffusionSurfaces& surfaces, const glm::dvec3& origin, const glm::dvec3& direction) {
  Hit first;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    const std::optional<Hit> hit = hit_triangle(surfaces, t, origin, direction);
    if (hit && hit->distance < first.distance) first = *hit;
  }
  return first;
}

double corner_angle(double u, double v) { return std::atan2(u * v, std::sqrt(u * u + v * v + 1)); }

}  // namespace

PmvcValue brute_force_pmvc(const DiffusionSurfaces& surfaces, const glm::dvec3& point, int texels, Mistake mistake) {
  const bool is_uniform = mistake == Mistake::uniform_solid_angle || mistake == Mistake::both;
  const bool is_planar = mistake == Mistake::planar_distance || mistake == Mistake::both;
  PmvcValue value;
  std::vector<double> part_weight(surfaces.part_names.size(), 0);
  for (int i = 0; i < 6 * texels * texels; ++i) {
    // A direction and the solid angle that it represents.
    const double h = 1.0 / texels;
    const int face = i / (texels * texels);
    const double u = (2 * (i % texels) + 1) * h - 1, v = (2 * (i / texels % texels) + 1) * h - 1;
    const double length = std::sqrt(u * u + v * v + 1);
    const double angle = corner_angle(u - h, v - h) - corner_angle(u - h, v + h) - corner_angle(u + h, v - h) +
                         corner_angle(u + h, v + h);
    glm::dvec3 direction;
    direction[face / 2] = face % 2 == 0 ? 1 : -1;
    direction[(face / 2 + 1) % 3] = u;
    direction[(face / 2 + 2) % 3] = v;

    // The first surface in this direction.
    const Hit hit = first_hit(surfaces, point, direction / length);
    if (std::isinf(hit.distance)) continue;
    const double weight = (is_uniform ? h * h : angle) / (is_planar ? hit.distance / length : hit.distance);
    const glm::uvec3& t = surfaces.triangle[hit.triangle];
    const std::vector<Color>& color = hit.is_front ? surfaces.front_color : surfaces.back_color;
    for (int k = 0; k < 3; ++k) value.color += weight * hit.barycentric[k] * glm::dvec3(color[t[k]]);
    value.weight += weight;
    part_weight[static_cast<std::size_t>((hit.is_front ? surfaces.front_part : surfaces.back_part)[hit.triangle])] +=
        weight;
  }
  if (value.weight > 0) value.color /= value.weight;
  value.part =
      static_cast<std::int32_t>(std::max_element(part_weight.begin(), part_weight.end()) - part_weight.begin());
  return value;
}

}  // namespace pomona
