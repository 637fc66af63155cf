#include "generator/surface/shell_geometry.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

glm::dvec3 at(const DiffusionSurfaces& surfaces, std::uint32_t vertex) { return glm::dvec3(surfaces.position[vertex]); }

void measure(const DiffusionSurfaces& surfaces, Shell& shell) {
  for (const glm::uvec3& t : shell.triangles) {
    for (int k = 0; k < 3; ++k) shell.bounds.add(at(surfaces, t[k]));
  }
  const glm::dvec3 center = shell.bounds.center();
  for (const glm::uvec3& t : shell.triangles) {
    const glm::dvec3 a = at(surfaces, t.x) - center, b = at(surfaces, t.y) - center, c = at(surfaces, t.z) - center;
    shell.volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
}

}  // namespace

std::vector<Shell> measured_shells(const DiffusionSurfaces& surfaces, const Shells& shells) {
  std::vector<Shell> measured(shells.count());
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (shells.of_triangle[i] == Shells::none) continue;
    measured[static_cast<std::size_t>(shells.of_triangle[i])].triangles.push_back(shells.air_facing[i]);
  }
  for (std::size_t s = 0; s < measured.size(); ++s) {
    measured[s].closed = shells.closed[s] != 0;
    measure(surfaces, measured[s]);
  }
  return measured;
}

bool Containment::contains(const Shell& outer, const Shell& inner) {
  const glm::dvec3 reach = 1e-6 * outer.bounds.size();
  if (glm::any(glm::lessThan(inner.bounds.low, outer.bounds.low - reach)) ||
      glm::any(glm::greaterThan(inner.bounds.high, outer.bounds.high + reach))) {
    return false;
  }
  const std::size_t samples = std::min<std::size_t>(8, inner.triangles.size());
  double sum = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const glm::uvec3& t = inner.triangles[k * inner.triangles.size() / samples];
    sum += winding_number(outer, (at(surfaces_, t.x) + at(surfaces_, t.y) + at(surfaces_, t.z)) / 3.0);
  }
  return std::fabs(sum) > 0.5 * static_cast<double>(samples);
}

/// Sum of solid angles [van Oosterom & Strackee 1983] over the full sphere's.
double Containment::winding_number(const Shell& shell, const glm::dvec3& point) {
  solid_angles_left_ -= static_cast<double>(shell.triangles.size());
  if (solid_angles_left_ < 0) {
    throw Error(ExitStatus::bad_data, "too many shells inside each other to tell solid from hollow",
                "remove loose bits of boundary surfaces");
  }
  double sum = 0;
  for (const glm::uvec3& t : shell.triangles) {
    const glm::dvec3 a = at(surfaces_, t.x) - point, b = at(surfaces_, t.y) - point, c = at(surfaces_, t.z) - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double y = glm::dot(a, glm::cross(b, c));
    const double x = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    if (x != 0 || y != 0) sum += 2 * reproducible::atan2(y, x);
  }
  return sum / (4 * pi);
}

}  // namespace pomona
