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
      solid.mesh.position.emplace_back(p.x * reproducible::cos(a), p.y, -p.x * reproducible::sin(a));
  }
  for (unsigned c = 0; c < static_cast<unsigned>(around); ++c) {
    for (unsigned r = 0; r + (closed ? 0 : 1) < rows; ++r) {
      const unsigned next = (c + 1) % columns, up = (r + 1) % rows;
      const unsigned v00 = c * rows + r, v01 = c * rows + up, v10 = next * rows + r, v11 = next * rows + up;
      if (solid.mesh.position[v00] != solid.mesh.position[v10]) solid.mesh.triangle.push_back({v00, v10, v11});
      if (solid.mesh.position[v01] != solid.mesh.position[v11]) solid.mesh.triangle.push_back({v00, v11, v01});
    }
  }
  // The two flat faces of a part: fans, for convex profiles.
  if (!full) {
    const unsigned last = (columns - 1) * rows;
    for (unsigned r = 2; r < rows; ++r) {
      solid.mesh.triangle.push_back({0, r - 1, r});
      solid.mesh.triangle.push_back({last, last + r, last + r - 1});
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

Solid disc(double radius, double height) {
  Solid solid = revolved({{0, 0}, {radius, 0}, {radius, height}, {0, height}}, false, 32, 2 * pi, "disc");
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const auto at = [&](unsigned i) { return solid.mesh.position[i].y; };
    const bool is_flat = at(t.x) == at(t.y) && at(t.y) == at(t.z);
    solid.mesh.cut_face.push_back(!is_flat ? -1 : at(t.x) > 0 ? 1 : 0);
  }
  return solid;
}

namespace {

/// Adds the eight corners of a box and its outward faces.
void add_box(Solid& solid, const glm::dvec3& low, const glm::dvec3& high) {
  const auto first = static_cast<unsigned>(solid.mesh.position.size());
  for (unsigned i = 0; i < 8; ++i)
    solid.mesh.position.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                     (i & 4) != 0 ? high.z : low.z);
  const unsigned faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces) {
    solid.mesh.triangle.push_back(glm::uvec3(f[0], f[1], f[2]) + first);
    solid.mesh.triangle.push_back(glm::uvec3(f[0], f[2], f[3]) + first);
  }
}

}  // namespace

Solid slab(const glm::dvec3& size) {
  Solid solid;
  solid.name = "slab";
  add_box(solid, {-0.5 * size.x, 0, -0.5 * size.z}, {0.5 * size.x, size.y, 0.5 * size.z});
  return solid;
}

Solid tray(const glm::dvec3& size, double wall) {
  Solid solid = slab({size.x, wall, size.z});
  solid.name = "tray";
  const double x = 0.5 * size.x, z = 0.5 * size.z;
  add_box(solid, {-x, 0, -z}, {-x + wall, size.y, z});
  add_box(solid, {x - wall, 0, -z}, {x, size.y, z});
  add_box(solid, {-x, 0, -z}, {x, size.y, -z + wall});
  add_box(solid, {-x, 0, z - wall}, {x, size.y, z});
  return solid;
}

Solid upright_sheet(double size) {
  Solid solid;
  solid.name = "sheet";
  const auto s = static_cast<float>(size);
  solid.mesh.position = {{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}};
  solid.mesh.triangle = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  return solid;
}

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
