#include "generator/mesh/triangle_weights.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

const std::array<glm::dvec3, 3> corner = {{{0.1, 0.2, 0.3}, {1.3, 0.1, -0.4}, {0.2, 1.7, 0.5}}};

TEST(TriangleWeights, MakeThePoint) {
  const RandomStream random({}, "tests/weights");
  for (std::uint64_t n = 0; n < 200; n += 2) {
    double v = random.uniform(n), w = random.uniform(n + 1);
    if (v + w > 1) v = 1 - v, w = 1 - w;
    const glm::dvec3 p = (1 - v - w) * corner[0] + v * corner[1] + w * corner[2];
    const std::array<double, 3> weight = weights_in(corner, p);
    EXPECT_NEAR(weight[1], v, 1e-14);
    EXPECT_NEAR(weight[2], w, 1e-14);
    EXPECT_NEAR(weight[0] + weight[1] + weight[2], 1, 1e-15);
  }
}

TEST(TriangleWeights, StayBetweenZeroAndOneForPointsBeside) {
  const glm::dvec3 beside = corner[0] - 0.1 * (corner[1] - corner[0]) + 0.3 * (corner[2] - corner[0]);
  const std::array<double, 3> weight = weights_in(corner, beside);
  EXPECT_EQ(weight[1], 0);
  EXPECT_NEAR(weight[0], 0.8 / 1.1, 1e-12);
  EXPECT_NEAR(weight[2], 0.3 / 1.1, 1e-12);
  EXPECT_EQ(weights_in({corner[0], corner[1], corner[1]}, corner[1]), (std::array<double, 3>{1, 0, 0}));
}

}  // namespace
}  // namespace pomona
