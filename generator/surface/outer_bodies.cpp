#include "generator/surface/outer_bodies.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/surface/shell_geometry.h"

namespace pomona {

namespace {

constexpr double min_length = 0.1;  // smallest length, as a share of the skin's diagonal

/// True if the first corner of any triangle of the body is outside the skin.
bool sticks_out(const TriangleTree& body, const TriangleTree& skin) {
  return std::any_of(body.triangles().begin(), body.triangles().end(),
                     [&](const TriangleTree::Corners& t) { return !skin.contains(t[0]); });
}

}  // namespace

OuterBodies outer_bodies(const DiffusionSurfaces& surfaces, const TriangleTree& skin) {
  OuterBodies outer;
  const double size = glm::length(skin.box().high - skin.box().low);
  const Shells shells = find_shells(surfaces);
  const std::vector<Shell> measured = measured_shells(surfaces, shells);
  std::vector<std::int32_t> body_of_shell(measured.size(), OuterBodies::none);
  for (std::size_t s = 0; s < measured.size(); ++s) {
    const Shell& shell = measured[s];
    if (!shell.closed || shell.volume <= 0 || glm::length(shell.bounds.size()) < min_length * size) continue;
    TriangleTree body(surfaces.position, shell.triangles);
    // The main body itself is among the shells, and is none of them.
    if (body.triangles() == skin.triangles() || !sticks_out(body, skin)) continue;
    body_of_shell[s] = static_cast<std::int32_t>(outer.body.size());
    outer.body.push_back(std::move(body));
  }
  for (const std::int32_t shell : shells.of_triangle)
    outer.of_triangle.push_back(shell == Shells::none ? OuterBodies::none
                                                      : body_of_shell[static_cast<std::size_t>(shell)]);
  return outer;
}

}  // namespace pomona
