#include "tests/cut/solid_shapes.h"

#include <utility>

#include <glm/mat3x3.hpp>

#include "generator/base/reproducible.h"
#include "tests/shapes/shapes.h"

namespace pomona::shapes {

namespace {

constexpr double pi = 3.14159265358979323846;

ClosedSurface solid_of(const DiffusionSurfaces& surfaces) {
  ClosedSurface solid;
  for (const glm::vec3& p : surfaces.position) solid.point.emplace_back(p);
  solid.triangle = surfaces.triangle;
  return solid;
}

}  // namespace

ClosedSurface ball(const glm::dvec3& center, double radius, int n) {
  ClosedSurface solid = solid_of(sphere(1, n));
  for (glm::dvec3& p : solid.point) p = center + radius * p;
  return solid;
}

ClosedSurface block(const glm::dvec3& low, const glm::dvec3& high) {
  ClosedSurface solid = solid_of(box({0, 0, 0}, {1, 1, 1}));
  for (glm::dvec3& p : solid.point)
    p = glm::dvec3(p.x > 0 ? high.x : low.x, p.y > 0 ? high.y : low.y, p.z > 0 ? high.z : low.z);
  return solid;
}

ClosedSurface rod(const glm::dvec3& bottom, double radius, double height, int around) {
  ClosedSurface solid;
  const glm::dvec3 top = bottom + glm::dvec3(0, height, 0);
  solid.point = {bottom, top};
  const auto n = static_cast<std::uint32_t>(around);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / around;
    const glm::dvec3 out(radius * reproducible::cos(angle), 0, -radius * reproducible::sin(angle));
    solid.point.push_back(bottom + out);
    solid.point.push_back(top + out);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t low = 2 + 2 * i, high = low + 1, next_low = 2 + 2 * ((i + 1) % n), next_high = next_low + 1;
    solid.triangle.insert(
        solid.triangle.end(),
        {{low, next_low, next_high}, {low, next_high, high}, {0, next_low, low}, {1, high, next_high}});
  }
  return solid;
}

ClosedSurface tilted(ClosedSurface solid) {
  const glm::dmat3 turn(glm::dvec3(0.36, 0.48, -0.8), glm::dvec3(-0.8, 0.6, 0), glm::dvec3(0.48, 0.64, 0.6));
  for (glm::dvec3& p : solid.point) p = turn * p;
  return solid;
}

Knife solid_knife(ClosedSurface solid) {
  return {ClosedCut(SurfaceKnife{std::make_shared<const ClosedSurface>(std::move(solid))}), "solid"};
}

}  // namespace pomona::shapes
