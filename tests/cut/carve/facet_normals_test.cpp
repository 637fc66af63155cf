#include "generator/cut/carve/facet_normals.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

const std::array<glm::dvec3, 3> corner = {{{0.1, 0.2, 0.3}, {1.3, 0.1, -0.4}, {0.2, 1.7, 0.5}}};

TEST(FacetNormals, AShareOfTheWayIsAtMostOne) {
  EXPECT_DOUBLE_EQ(share_between({0, 0, 0}, {0, 4, 0}, {0, 1, 0}), 0.25);
  EXPECT_EQ(share_between({0, 0, 0}, {0, 4, 0}, {0, 5, 0}), 1);
}

/// Two triangles at the edge from point 0 to point 1, which has point 4 on it; point 5 lies within the first.
struct TwoFacets {
  std::vector<glm::dvec3> points = {corner[0], corner[1], corner[2], {0.6, -1, 0.2}, {}, {}};
  Arrangement::Facet first, second;

  TwoFacets() {
    points[4] = corner[0] + 0.37 * (corner[1] - corner[0]);
    points[5] = (corner[0] + corner[1] + corner[2]) / 3.0;
    first.corner = {0, 1, 2};
    first.mesh.chain = {{0, 4, 1}, {1, 2}, {2, 0}};
    second.corner = {3, 1, 0};
    second.mesh.chain = {{3, 1}, {1, 4, 0}, {0, 3}};
  }
};

TEST(FacetNormals, AgreeAlongACommonEdgeToTheBit) {
  const TwoFacets two;
  const glm::dvec3 a = glm::normalize(glm::dvec3(1, 2, 3)), b = glm::normalize(glm::dvec3(3, -1, 2));
  const glm::vec3 by_first = normal_at(4, two.first, {a, b, {0, 0, 1}}, two.points);
  EXPECT_EQ(by_first, normal_at(4, two.second, {glm::dvec3(1, 0, 0), b, a}, two.points));
  // Where normals nearly cancel, the last bits of the share matter.
  const glm::dvec3 east(1, 0, 0), west(-1, 1e-12, 0);
  TwoFacets halved = two;
  halved.points[4] = 0.5 * (corner[0] + corner[1]);
  for (int i = 0; i < 50; ++i) {
    halved.points[4] += 1e-14 * (corner[1] - corner[0]);
    EXPECT_EQ(normal_at(4, halved.first, {east, west, a}, halved.points),
              normal_at(4, halved.second, {a, west, east}, halved.points));
  }
  const glm::dvec3 wanted = glm::normalize(0.63 * a + 0.37 * b);
  EXPECT_LT(glm::distance(glm::dvec3(by_first), wanted), 1e-6);
}

TEST(FacetNormals, AreThoseOfTheCornersThereAndTheirMeanInTheMiddle) {
  const TwoFacets two;
  const std::array<glm::dvec3, 3> normal = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(normal_at(i, two.first, normal, two.points), glm::vec3(normal[i]));
  const glm::dvec3 middle(normal_at(5, two.first, normal, two.points));
  EXPECT_LT(glm::distance(middle, glm::normalize(glm::dvec3(1))), 1e-6);
}

TEST(FacetNormals, AreThatOfTheFirstCornerWhereTheyCancel) {
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}};
  Arrangement::Facet facet;
  facet.corner = {0, 1, 2};
  facet.mesh.chain = {{0, 3, 1}, {1, 2}, {2, 0}};
  const glm::dvec3 up(0, 1, 0);
  EXPECT_EQ(normal_at(3, facet, {up, -up, up}, points), glm::vec3(up));
}

}  // namespace
}  // namespace pomona
