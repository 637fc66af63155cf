#include "generator/surface/bodies.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/stop_watch.h"
#include "generator/base/units.h"
#include "generator/surface/shell_geometry.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using namespace shapes;

/// Of a closed surface with air inside.
Paint wall_paint() {
  Paint paint;
  paint.back_hidden = true;
  return paint;
}

TEST(Bodies, ASkinIsOneClosedBody) {
  const DiffusionSurfaces ball = tilted(sphere(1, 16, skin_paint()));
  const Bodies found = find_bodies(ball);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_TRUE(found.bodies[0].closed);
  EXPECT_NEAR(found.bodies[0].volume, signed_volume(ball), 1e-6);
  EXPECT_THAT(found.of_triangle, testing::Each(0));
  EXPECT_TRUE(found.warnings.empty());
}

TEST(Bodies, InnerSurfacesBoundNothing) {
  const Bodies found = find_bodies(nested_spheres(1, 0.5, 4));
  EXPECT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.of_triangle.front(), 0);
  EXPECT_EQ(found.of_triangle.back(), Bodies::none);
}

TEST(Bodies, ACavityWallBelongsToTheSkinAroundIt) {
  const DiffusionSurfaces ball = hollow_ball(1, 0.5, 16);
  const Bodies found = find_bodies(ball);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.bodies[0].shells, 2);
  EXPECT_NEAR(found.bodies[0].volume, signed_volume(sphere(1, 16)) - signed_volume(sphere(0.5, 16)), 1e-6);
}

TEST(Bodies, ASeedInAHollowIsItsOwnBodyAndKeepsItsOwnHollow) {
  const DiffusionSurfaces fruit = joined(hollow_ball(1, 0.6, 8), moved(hollow_ball(0.2, 0.1, 4), {0.1, 0, 0}));
  const Bodies found = find_bodies(fruit);
  ASSERT_EQ(found.bodies.size(), 2u);
  EXPECT_EQ(found.bodies[0].shells, 2);
  EXPECT_EQ(found.bodies[1].shells, 2);
  EXPECT_EQ(found.of_triangle.back(), 1);
}

TEST(Bodies, OverlappingAndTouchingBodiesStayTwo) {
  EXPECT_EQ(find_bodies(joined(sphere(1, 8, skin_paint()), moved(sphere(1, 8, skin_paint()), {1, 0, 0}))).bodies.size(),
            2u);
  const DiffusionSurfaces left = box({-1, 0, 0}, {0, 1, 1}, 2, skin_paint());
  for (const glm::dvec3 low : {glm::dvec3(0, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 1)}) {
    const DiffusionSurfaces right = box(low, low + 1.0, 2, skin_paint());
    DiffusionSurfaces both = joined(left, right);
    EXPECT_EQ(find_bodies(both).bodies.size(), 2u);
    both.surface.assign(both.triangle_count(), 0);
    const Bodies found = find_bodies(both);
    ASSERT_EQ(found.bodies.size(), 2u);
    EXPECT_TRUE(found.bodies[0].closed && found.bodies[1].closed);
    EXPECT_NEAR(found.bodies[1].volume, 1, 1e-6);
  }
}

TEST(Bodies, ABodyThatTouchesOthersAtAllItsEdgesIsOneStill) {
  // A cube, and at each of its twelve edges another cube that touches only this edge, in every order.
  std::vector<glm::dvec3> places{{0, 0, 0}};
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-1.0, 1.0}) places.insert(places.end(), {{a, b, 0}, {a, 0, b}, {0, a, b}});
  }
  for (std::size_t turn = 0; turn < places.size(); ++turn) {
    DiffusionSurfaces all;
    for (const glm::dvec3& low : places) all = joined(all, box(low, low + 1.0, 1, skin_paint()));
    const Bodies found = find_bodies(all);
    ASSERT_EQ(found.bodies.size(), places.size()) << turn;
    for (const auto& body : found.bodies) {
      EXPECT_TRUE(body.closed);
      EXPECT_EQ(body.shells, 1);
      EXPECT_NEAR(body.volume, 1, 1e-6);
    }
    std::rotate(places.begin(), places.begin() + 1, places.end());
  }
}

TEST(Bodies, ACavityWallBelongsToTheSmallestBodyAroundIt) {
  // Balls within balls: solid, hollow, solid, hollow; and beside the hollow of the inner one a bubble in the outer.
  DiffusionSurfaces all = joined(hollow_ball(1, 0.7, 8), moved(hollow_ball(0.5, 0.2, 8), {0.1, 0, 0}));
  all = joined(all, moved(sphere(0.05, 4, wall_paint()), {0, 0.85, 0}));
  const Bodies found = find_bodies(all);
  ASSERT_EQ(found.bodies.size(), 2u);
  EXPECT_EQ(found.bodies[0].shells, 3);
  EXPECT_EQ(found.bodies[1].shells, 2);
  EXPECT_EQ(found.of_triangle.back(), 0);
}

TEST(Bodies, TenThousandBubblesAreFoundInASecond) {
  constexpr int across = 22;  // 10 648
  DiffusionSurfaces bread = box({0, 0, 0}, glm::dvec3(across), 1, skin_paint());
  const DiffusionSurfaces bubble = sphere(0.3, 1, wall_paint());
  std::vector<DiffusionSurfaces> bubbles;
  for (int i = 0; i < across * across * across; ++i)
    bubbles.push_back(moved(bubble, glm::dvec3(i % across, i / across % across, i / across / across) + 0.5));
  while (bubbles.size() > 1) {
    const std::size_t half = (bubbles.size() + 1) / 2;
    for (std::size_t i = 0; i + half < bubbles.size(); ++i) bubbles[i] = joined(bubbles[i], bubbles[i + half]);
    bubbles.resize(half);
  }
  bread = joined(bread, bubbles.front());
  const StopWatch watch;
  const Bodies found = find_bodies(bread);
  EXPECT_LT(watch.milliseconds(), 10 * 1000) << "in proportion: a quarter of a second where nothing else runs";
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.bodies[0].shells, across * across * across + 1);
}

TEST(Containment, IsToldUntilItsBudgetIsSpent) {
  const DiffusionSurfaces both = joined(hollow_ball(1, 0.5, 2), moved(sphere(0.1, 1, skin_paint()), {0, 0.7, 0}));
  const std::vector<Shell> shells = measured_shells(both, find_shells(both));
  ASSERT_EQ(shells.size(), 3u);
  Containment containment(both, shells, {0, 1});
  EXPECT_EQ(containment.smallest_around(1), std::optional<std::size_t>(0));
  EXPECT_EQ(containment.smallest_around(2), std::optional<std::size_t>(0)) << "it lies beside the hollow";
  EXPECT_EQ(containment.smallest_around(0), std::nullopt);
  Containment poor(both, shells, {0, 1}, 8);
  EXPECT_THROW(poor.smallest_around(1), Error);
}

TEST(Containment, TakesShellsWithAHoleByTheirSolidAngle) {
  DiffusionSurfaces ball = joined(sphere(1, 8, skin_paint()), sphere(0.5, 4, skin_paint()));
  for (std::size_t t = 0; t < 2; ++t) {
    ball.triangle.erase(ball.triangle.begin());
    ball.surface.erase(ball.surface.begin());
    ball.front_part.erase(ball.front_part.begin());
    ball.back_part.erase(ball.back_part.begin());
  }
  const std::vector<Shell> shells = measured_shells(ball, find_shells(ball));
  ASSERT_EQ(shells.size(), 2u);
  ASSERT_FALSE(shells[0].closed);
  EXPECT_EQ(Containment(ball, shells, {0}).smallest_around(1), std::optional<std::size_t>(0));
}

TEST(Bodies, OpenBoundariesWarnByName) {
  const Bodies found = find_bodies(open_sheet(1, 0, 2, skin_paint()));
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_FALSE(found.bodies[0].closed);
  EXPECT_THAT(found.warnings, testing::ElementsAre("surface \"skin\" is open: pieces will be open there"));
}

TEST(Bodies, SurfacesThatNoneHidesWarn) {
  const Bodies found = find_bodies(sphere(1, 4, Paint{}));
  EXPECT_TRUE(found.bodies.empty());
  EXPECT_THAT(found.warnings, testing::ElementsAre(testing::HasSubstr("no surface has a hidden side")));
}

TEST(Bodies, AShellInsideOutIsClosedButWarned) {
  const Bodies found = find_bodies(sphere(1, 4, wall_paint()));
  EXPECT_EQ(found.bodies.size(), 1u);
  EXPECT_EQ(found.bodies[0].volume, 0);
  EXPECT_EQ(found.warnings.size(), 1u);
}

TEST(Bodies, SidesMayBeGivenEitherWay) {
  const Bodies found = find_bodies(turned_inside_out(hollow_ball(1, 0.5, 8)));
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_GT(found.bodies[0].volume, 3);
}

TEST(Bodies, BothSidesHiddenIsAnError) {
  Paint paint = skin_paint();
  paint.back_hidden = true;
  EXPECT_THROW(find_bodies(sphere(1, 2, paint)), Error);
}

TEST(Bodies, SeamsWeldAndDegenerateTrianglesAreHarmless) {
  // Every triangle has vertices of its own; three triangles have no area.
  const DiffusionSurfaces ball = sphere(1, 4, skin_paint());
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> triangle;
  for (const glm::uvec3& t : ball.triangle) {
    const auto first = static_cast<std::uint32_t>(position.size());
    for (int k = 0; k < 3; ++k) position.push_back(ball.position[t[k]]);
    triangle.emplace_back(first, first + 1, first + 2);
  }
  triangle.emplace_back(0u, 0u, 1u);
  triangle.emplace_back(2u, 2u, 2u);
  const DiffusionSurfaces soup = painted(position, triangle, skin_paint());
  const Bodies found = find_bodies(soup);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_TRUE(found.bodies[0].closed);
  EXPECT_THAT(found.of_triangle, testing::Each(0));
  EXPECT_EQ(vertex_normals(soup)[0], vertex_normals(ball)[ball.triangle[0].x]);
}

TEST(Bodies, NothingHasNoBodies) { EXPECT_TRUE(find_bodies({}).bodies.empty()); }

TEST(VertexNormals, PointOutOfASphere) {
  const DiffusionSurfaces ball = sphere(2, 16);
  const std::vector<glm::vec3> normals = vertex_normals(ball);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    EXPECT_GT(glm::dot(normals[v], glm::normalize(ball.position[v])), 0.999f);
    EXPECT_NEAR(glm::length(normals[v]), 1, 1e-6);
  }
}

}  // namespace
}  // namespace pomona
