// The exact side of a plane, against arithmetic of 113 bits.
#include "generator/knife/exact_side.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/random.h"

namespace pomona {
namespace {

__extension__ using Quad = __float128;

TEST(ExactSide, IsThatOfAMoreExactSum) {
  const RandomStream random({3, 0}, "test/exact_side");
  int zeros = 0, wrong_in_doubles = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto number = [&](std::uint64_t k) { return 2 * random.uniform(16 * i + k) - 1; };
    CuttingPlane plane;
    plane.normal = glm::normalize(glm::dvec3(number(0), number(1), number(2)));
    const glm::dvec3 point(glm::vec3(0.05 * number(3), 0.05 * number(4), 0.05 * number(5)));

    // The plane passes through the point, except for the last bits.
    plane.offset = glm::dot(plane.normal, point);
    const auto steps = static_cast<int>(random.below(16 * i + 6, 5)) - 2;
    for (int s = 0; s < std::abs(steps); ++s) plane.offset = std::nextafter(plane.offset, steps < 0 ? -1.0 : 1.0);

    Quad exact = -Quad(plane.offset);
    for (int axis = 0; axis < 3; ++axis) exact += Quad(plane.normal[axis]) * Quad(point[axis]);
    const double distance = exact_distance(plane, point);
    EXPECT_EQ(distance > 0, exact > 0);
    EXPECT_EQ(distance < 0, exact < 0);
    EXPECT_NEAR(distance, static_cast<double>(exact), 1e-6 * std::fabs(static_cast<double>(exact)));
    zeros += exact == 0;
    const double rounded = glm::dot(plane.normal, point) - plane.offset;
    wrong_in_doubles += (rounded > 0) != (exact > 0) || (rounded < 0) != (exact < 0);
  }
  EXPECT_GT(wrong_in_doubles, 1000) << "the test has no teeth";
  EXPECT_LT(zeros, 1000);
}

TEST(ExactSide, KnowsZero) {
  EXPECT_EQ(exact_distance({{0, 0, 1}, 0}, {0.03, 0.04, 0}), 0);
  EXPECT_EQ(exact_distance({{0.6, 0.8, 0}, 0}, {0.8, -0.6, 5}), 0);
  EXPECT_EQ(exact_distance({{1, 1, 1}, 0.75}, {0.25, 0.25, 0.25}), 0);
  EXPECT_GT(exact_distance({{1, 1, 1}, 0}, {1, -1, 1e-200}), 0);
  EXPECT_LT(exact_distance({{1, 1, 1}, 0}, {1e20, -1e20, -1e-20}), 0);
}

}  // namespace
}  // namespace pomona
