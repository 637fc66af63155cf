// Mass, centre and inertia, against formulas for simple solids.
#include "generator/mesh/moments.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

Moments moments_about(const DiffusionSurfaces& mesh, const glm::dvec3& origin) {
  return moments_of(mesh.position, mesh.triangle, origin);
}

TEST(Moments, OfABoxAreThoseOfTheTextbook) {
  const glm::dvec3 low(0.5, -0.25, 0.125), size(0.25, 0.5, 0.0625);  // floats hold these exactly
  const glm::dvec3 origin(1, 2, 3);
  const RigidMass box = rigid_mass(moments_about(shapes::box(low, low + size, 2), origin), origin);
  const double volume = size.x * size.y * size.z;
  EXPECT_NEAR(box.mass, volume, 1e-12 * volume);
  EXPECT_LT(glm::distance(box.center, low + 0.5 * size), 1e-11);
  const glm::dvec3 square = size * size;
  const glm::dvec3 about = volume / 12 * glm::dvec3(square.y + square.z, square.x + square.z, square.x + square.y);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(box.inertia[i][k], i == k ? about[i] : 0, 1e-9 * volume);
  }
}

TEST(Moments, OfPartsAddUpToThoseOfTheWhole) {
  const glm::dvec3 origin(0.1, 0.2, -0.3);
  Moments sum;
  sum.add(moments_about(shapes::box({0, 0, 0}, {1, 0.5, 2}), origin));
  sum.add(moments_about(shapes::box({1, 0, 0}, {1.5, 0.5, 2}), origin));
  const Moments whole = moments_about(shapes::box({0, 0, 0}, {1.5, 0.5, 2}), origin);
  EXPECT_NEAR(sum.mass, whole.mass, 1e-14);
  EXPECT_LT(glm::distance(sum.first, whole.first), 1e-14);
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(sum.second[i], whole.second[i]), 1e-14);
}

TEST(Moments, OfNothingAreNone) {
  const RigidMass none = rigid_mass({}, {1, 2, 3});
  EXPECT_EQ(none.mass, 0);
  EXPECT_EQ(none.center, glm::dvec3(1, 2, 3));
}

}  // namespace
}  // namespace pomona
