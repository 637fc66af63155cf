#include "tests/scene/heap_shapes.h"

#include <glm/vec2.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona::heap_shapes {

namespace {

/// A closed or axis-to-axis profile (radius, height) turned about the y axis; the outside lies to the right of it.
Solid revolved(const std::vector<glm::dvec2>& profile, bool closed, int around, double angle, const std::string& name) {
  Solid solid;
  solid.name = name;
  const bool full = angle >= 2 * pi;
  const unsigned columns = static_cast<unsigned>(around) + (full ? 0 : 1);
  const auto rows = static_cast<unsigned>(profile.size());
  for (unsigned c = 0; c < columns; ++c) {
    const double a = angle * c / around;
    for (const glm::dvec2& p : profile)
      solid.position.emplace_back(p.x * reproducible::cos(a), p.y, -p.x * reproducible::sin(a));
  }
  for (unsigned c = 0; c < static_cast<unsigned>(around); ++c) {
    for (unsigned r = 0; r + (closed ? 0 : 1) < rows; ++r) {
      const unsigned next = (c + 1) % columns, up = (r + 1) % rows;
      const unsigned v00 = c * rows + r, v01 = c * rows + up, v10 = next * rows + r, v11 = next * rows + up;
      if (solid.position[v00] != solid.position[v10]) solid.triangle.push_back({v00, v10, v11});
      if (solid.position[v01] != solid.position[v11]) solid.triangle.push_back({v00, v11, v01});
    }
  }
  // The two flat faces of a part: fans, for convex profiles.
  if (!full) {
    const unsigned last = (columns - 1) * rows;
    for (unsigned r = 2; r < rows; ++r) {
      solid.triangle.push_back({0, r - 1, r});
      solid.triangle.push_back({last, last + r, last + r - 1});
    }
  }
  return solid;
}

std::vector<glm::dvec2> arc(double radius, int steps) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double a = pi * i / steps - pi / 2;
    points.emplace_back(i == 0 || i == steps ? 0 : radius * reproducible::cos(a), radius * reproducible::sin(a));
  }
  return points;
}

}  // namespace

Solid ball(double radius) { return revolved(arc(radius, 16), false, 32, 2 * pi, "ball"); }

Solid ring(double outer, double inner, double height) {
  const double h = height / 2;
  return revolved({{inner, -h}, {outer, -h}, {outer, 0}, {outer, h}, {inner, h}, {inner, 0}}, true, 48, 2 * pi, "ring");
}

Solid wedge(double radius, double degrees) { return revolved(arc(radius, 16), false, 12, radians(degrees), "wedge"); }

Solid bowl(double radius, double depth) {
  constexpr double wall = 0.005;
  std::vector<glm::dvec2> profile;
  const int steps = 20;
  const auto height = [&](double r) { return depth * (r / radius) * (r / radius); };
  for (int i = 0; i <= steps; ++i) {
    const double r = radius * i / steps;
    profile.emplace_back(r, height(r));
  }
  for (int i = steps; i >= 0; --i) {
    const double r = (radius - wall) * i / steps;
    profile.emplace_back(r, height(r) + wall);
  }
  return revolved(profile, false, 64, 2 * pi, "bowl");
}

}  // namespace pomona::heap_shapes
