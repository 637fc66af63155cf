// Where the surfaces of a variant cross.
#include "generator/variation/swept_check.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "generator/surface/crossings.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/unpainted.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

/// An onion whose inner layer crosses the outer one on the side of +X.
Template burst() {
  Template fruit = fruits::onion(2);
  for (Curve& loop : fruit.surfaces[1].horizontal) {
    for (glm::dvec2& p : loop.points) {
      if (p.x > 0 && std::abs(p.y) < 0.5 * p.x) p *= 2.0;
    }
  }
  return fruit;
}

TEST(SweptCheck, FindsNothingNewInTheDrawingItself) {
  const Template drawn = fruits::onion(2);
  EXPECT_TRUE(SweptCheck(drawn).new_crossings(drawn).empty());
  EXPECT_FALSE(SweptCheck(drawn).crosses_anew(drawn));
}

TEST(SweptCheck, TellsTheAzimuthsOfTheMiddlesOfWhatCrosses) {
  const Template variant = burst();
  const std::vector<double> azimuths = SweptCheck(fruits::onion(2)).new_crossings(variant);
  const DiffusionSurfaces swept = sweep(unpainted(variant));
  const std::vector<CrossingTriangles> crossings = crossing_triangles(swept);
  ASSERT_GT(crossings.size(), 10u);
  ASSERT_EQ(azimuths.size(), 2 * crossings.size());
  for (std::size_t i = 0; i < azimuths.size(); ++i) {
    const glm::uvec3& t = swept.triangle[i % 2 == 0 ? crossings[i / 2].first : crossings[i / 2].second];
    const glm::dvec3 sum =
        glm::dvec3(swept.position[t.x]) + glm::dvec3(swept.position[t.y]) + glm::dvec3(swept.position[t.z]);
    EXPECT_NEAR(azimuths[i], std::atan2(-sum.z, sum.x), 1e-9);
    EXPECT_LT(std::abs(azimuths[i]), 0.25 * pi) << "on the other side";
  }
}

}  // namespace
}  // namespace pomona
