#include "generator/scene/settle/fit_check.h"

#include <gtest/gtest.h>

#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

/// A floor whose upper side is y = 0.
PlacedMesh floor() {
  const Solid slab = heap_shapes::ring(0.5, 0.001, 0.02);
  return {TriangleTree(slab.mesh.position, slab.mesh.triangle), {0, -0.01, 0}, 1};
}

Pose at(double x, double y) { return {glm::dquat(1, 0, 0, 0), {x, y, 0}}; }

TEST(FitCheck, MeasuresGapsAndOverlapsOfBalls) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const PlacedMesh stand = floor();
  FitCheck check(solids, {0, 0, 0}, stand, {});
  const double size = glm::length(glm::dvec3(0.04));

  // One ball 1 mm above the floor; two balls high above that overlap by 2 mm.
  const std::vector<Pose> poses{at(0.2, 0.021), at(0, 0.1), at(0.038, 0.1)};
  const std::vector<Fit> fits = check.measure(poses);
  EXPECT_NEAR(fits[0].gap * size, 0.001, 1e-4);
  EXPECT_EQ(fits[0].penetration, 0);
  for (const std::size_t i : {1u, 2u}) {
    EXPECT_EQ(fits[i].gap, 0);
    EXPECT_NEAR(fits[i].penetration * size, 0.002, 2e-4);
  }
}

TEST(FitCheck, LooksNoFartherThanItSays) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const PlacedMesh stand = floor();
  FitCheck check(solids, {0}, stand, {});
  EXPECT_EQ(check.measure(std::vector<Pose>{at(0, 0.2)})[0].gap, farthest_gap);
}

TEST(FitCheck, MeasuresNothingAgainstWhatLiesNowhere) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const PlacedMesh stand = floor();
  FitCheck check(solids, {0, 0, 0}, stand, {});

  // The second would overlap both others, but it was not placed.
  const std::vector<Pose> poses{at(0, 0.0201), at(0.02, 0.0201), at(0.0401, 0.0201)};
  const std::vector<Fit> fits = check.measure(poses, std::vector<std::size_t>{1});
  for (const std::size_t i : {0u, 2u}) EXPECT_EQ(fits[i].penetration, 0) << i;
  EXPECT_GT(check.measure(poses)[0].penetration, 0.1) << "it lies there now";
}

/// Its cache does not change results.
TEST(FitCheck, MeasuresTheSameAgainAndAfterMoves) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02), heap_shapes::wedge(0.03, 90)};
  const PlacedMesh stand = floor();
  const std::vector<Pose> before{at(0, 0.02), at(0.035, 0.03), at(0.09, 0.02), at(0.2, 0.5)};
  std::vector<Pose> after = before;
  after[3] = at(0.06, 0.021);
  FitCheck twice(solids, {0, 1, 0, 1}, stand, {1}), fresh(solids, {0, 1, 0, 1}, stand, {2});
  twice.measure(before);
  const std::vector<Fit> remembered = twice.measure(after), anew = fresh.measure(after);
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(remembered[i].gap, anew[i].gap) << i;
    EXPECT_EQ(remembered[i].penetration, anew[i].penetration) << i;
  }
}

}  // namespace
}  // namespace pomona
