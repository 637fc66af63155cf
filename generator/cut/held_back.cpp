#include "generator/cut/held_back.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/triangle_tree.h"
#include "generator/surface/outer_bodies.h"
#include "generator/surface/skin_depth.h"

namespace pomona {

namespace {

constexpr std::uint32_t unset = 0xffffffffu;

/// Per outer body whether all of it lies in one cell, and no cut face goes through it.
std::vector<std::uint8_t> whole_ones(const CutFruit& fruit, const OuterBodies& outer, const Bodies& bodies) {
  std::vector<std::uint8_t> whole(outer.body.size(), 1);
  std::vector<std::uint32_t> cell(outer.body.size(), unset);
  std::vector<std::int32_t> body_of(outer.body.size(), Bodies::none);
  for (const SurfaceTriangle& t : fruit.surface) {
    if (outer.of_triangle[t.source] == OuterBodies::none) continue;
    const auto number = static_cast<std::size_t>(outer.of_triangle[t.source]);
    if (cell[number] != unset && cell[number] != t.cell) whole[number] = 0;
    cell[number] = t.cell;
    body_of[number] = bodies.of_triangle[t.source];
  }
  for (const Cap& cap : fruit.section.cap) {
    for (const BodyWinding& inside : cap.closing.inside) {
      for (std::size_t b = 0; b < body_of.size(); ++b)
        if (body_of[b] == inside.body) whole[b] = 0;
    }
  }
  return whole;
}

/// Of what is sunk in the skin, or of all of it if nothing is.
bool goes_inside(const TriangleTree& body, const TriangleTree& skin, const TriangleTree& knife) {
  double sunk = 0, sunk_inside = 0, all = 0, all_inside = 0;
  for (const TriangleTree::Corners& t : body.triangles()) {
    const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const double area = glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
    const double inside = knife.contains(middle) ? area : 0;
    all += area, all_inside += inside;
    if (!skin.contains(middle)) continue;
    sunk += area, sunk_inside += inside;
  }
  return sunk > 0 ? sunk_inside > 0.5 * sunk : all_inside > 0.5 * all;
}

}  // namespace

HeldBack held_back(CutFruit fruit, const ClosedSurface& knife, std::uint32_t stride, const DiffusionSurfaces& surfaces,
                   const Bodies& bodies) {
  const SkinDepth depth(surfaces);
  if (!depth.is_closed()) return {std::move(fruit), {}};
  const OuterBodies outer = outer_bodies(surfaces, depth.skin());
  const std::vector<std::uint8_t> whole = whole_ones(fruit, outer, bodies);
  const std::vector<glm::vec3> points(knife.point.begin(), knife.point.end());
  const TriangleTree tree(points, knife.triangle);
  std::vector<std::uint8_t> inside;
  for (const TriangleTree& body : outer.body) inside.push_back(goes_inside(body, depth.skin(), tree) ? 1 : 0);

  HeldBack held{std::move(fruit), {}};
  std::vector<SurfaceTriangle> rest;
  for (SurfaceTriangle t : held.fruit.surface) {
    const std::int32_t number = outer.of_triangle[t.source];
    if (number == OuterBodies::none || whole[static_cast<std::size_t>(number)] == 0) {
      rest.push_back(t);
      continue;
    }
    if (inside[static_cast<std::size_t>(number)] != 0) t.cell += stride;
    held.triangle.push_back(t);
  }
  held.fruit.surface = std::move(rest);
  return held;
}

}  // namespace pomona
