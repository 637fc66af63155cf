// Convex parts of hollow things: hollows stay open, walls are there.
#include "render/export/collision/collision_shape.h"
#include "render/export/collision/convex_parts.h"
#include "render/export/collision/cut_surface.h"
#include "render/export/collision/hull_bulge.h"
#include "render/export/collision/hull_cut.h"
#include "render/export/collision/solid_bodies.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/render/export/named_solids.h"
#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

/// The faces of all parts.
using PartFaces = std::vector<std::vector<collision::FacePlane>>;

PartFaces faces_of(const std::vector<ConvexHull>& parts) {
  PartFaces faces;
  for (const ConvexHull& part : parts) faces.push_back(collision::faces_of(part));
  return faces;
}

/// How deep the point lies in the part that holds it deepest.
double depth_in_any(const PartFaces& parts, const glm::dvec3& point) {
  double depth = -1;
  for (const std::vector<collision::FacePlane>& part : parts) depth = std::max(depth, collision::depth_in(part, point));
  return depth;
}

double volume_of(const std::vector<ConvexHull>& parts) {
  double sum = 0;
  for (const ConvexHull& part : parts) sum += volume_of(part);
  return sum;
}

/// The deepest of all places so far outside of the middles of the solid's triangles.
double deepest_outside(const Solid& solid, const PartFaces& parts, double away) {
  double deepest = -1;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const glm::dvec3 normal = glm::normalize(solid.mesh.area_vector(t));
    deepest = std::max(deepest, depth_in_any(parts, solid.mesh.place(t, glm::dvec3(1.0 / 3)) + away * normal));
  }
  return deepest;
}

/// The share of places so far inside of the middles of the triangles that lie in a part.
double covered(const Solid& solid, const PartFaces& parts, double inside) {
  double in = 0, all = 0;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const glm::dvec3 area = solid.mesh.area_vector(t);
    const glm::dvec3 place = solid.mesh.place(t, glm::dvec3(1.0 / 3)) - inside * glm::normalize(area);
    all += glm::length(area);
    if (depth_in_any(parts, place) > 0) in += glm::length(area);
  }
  return in / all;
}

TEST(Collision, HollowDishesStayOpen) {
  const Solid tray = heap_shapes::tray({0.3, 0.08, 0.2}, 0.01), bowl = heap_shapes::bowl(0.12, 0.06);
  for (const Solid& dish : {tray, bowl}) {
    const std::vector<ConvexHull> parts = collision_parts(dish, 1);
    ASSERT_GE(parts.size(), 5u);
    EXPECT_LE(parts.size(), 256u);
    const PartFaces faces = faces_of(parts);
    EXPECT_LT(deepest_outside(dish, faces, 5e-4), 0) << "nothing stands half a millimetre out of the walls";
    EXPECT_GT(covered(dish, faces, 1.5e-3), 0.9) << "and the walls are there";
  }
}

TEST(Collision, OneHullWouldFillTheTray) {
  const Solid tray = heap_shapes::tray({0.3, 0.08, 0.2}, 0.01);
  EXPECT_GT(depth_in_any(faces_of({convex_hull(tray.mesh.position)}), {0, 0.05, 0}), 0.02);
}

collision::CutSurface surface_of(const Solid& solid) {
  collision::CutSurface surface;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) surface.skin.push_back(solid.mesh.corners(t));
  return surface;
}

TEST(Collision, MoreHullsLeaveMoreOfARingOpen) {
  Solid ring = heap_shapes::ring(0.04, 0.025, 0.02);
  ring.origin.number = 1;
  ring.volume = surface_of(ring).volume();
  const double whole = volume_of(collision_parts(ring, 1));
  const std::vector<ConvexHull> parts = collision_parts(ring, 16);
  EXPECT_LE(parts.size(), 16u);
  EXPECT_LT(volume_of(parts), 1.1 * ring.volume);
  EXPECT_GT(volume_of(parts), 0.85 * ring.volume);
  EXPECT_GT(whole, 1.4 * ring.volume);
  EXPECT_LT(depth_in_any(faces_of(parts), {0, 0.01, 0}), 0) << "the hole is open";
}

TEST(Collision, ConvexThingsAreOnePart) {
  EXPECT_EQ(convex_parts(named::ball("ball", 0.03f, 12, Color(1))).size(), 1u);
  EXPECT_EQ(convex_parts(named::box("box", {0, 0, 0}, {1, 2, 3}, Color(1), Color(1))).size(), 1u);
}

TEST(Collision, BodiesThatTouchAreApart) {
  const Solid tray = heap_shapes::tray({0.3, 0.08, 0.2}, 0.01);
  EXPECT_EQ(collision::bodies_of(tray).size(), 5u) << "a floor and four walls, which share edges";
  EXPECT_EQ(convex_parts(tray).size(), 5u);
}

TEST(Collision, PartsHoldCornersWithinWalls) {
  // Three cuts that meet within the box: no corner of the part behind them but one lies on the skin.
  const Solid box = named::box("box", {0, 0, 0}, {1, 1, 1}, Color(1), Color(1));
  collision::CutSurface corner = surface_of(box);
  for (const glm::dvec3& normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
    corner = collision::divided(corner, {normal, 0.5})[0];
  EXPECT_NEAR(corner.volume(), 0.125, 1e-12);
  EXPECT_NEAR(volume_of(convex_hull(corner.points())), 0.125, 1e-6);
}

TEST(Collision, CutsKeepTheVolume) {
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  const collision::CutSurface surface = surface_of(bowl);
  const double whole = surface.volume();
  double sum = 0;
  for (const collision::CutSurface& half : collision::divided(surface, {{1, 0, 0}, 0.013})) {
    for (const collision::CutSurface& part : collision::divided(half, {{0, 0.6, 0.8}, 0.02})) {
      EXPECT_GT(part.volume(), 0);
      sum += part.volume();
    }
  }
  EXPECT_NEAR(sum, whole, 1e-12 * whole + 1e-18);
}

TEST(Collision, PartsAreTheSameEachTime) {
  const Solid bowl = heap_shapes::bowl(0.1, 0.05);
  const std::vector<ConvexHull> before = convex_parts(bowl, {.most = 8});
  const std::vector<ConvexHull> again = convex_parts(bowl, {.most = 8});
  ASSERT_EQ(before.size(), again.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].position, again[i].position);
}

}  // namespace
}  // namespace pomona
