// Guides between the nodes of a lattice that no cut moves.
#include "generator/cut/section/guide_lattice.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

const Box<double> box{{-0.03, -0.02, -0.025}, {0.03, 0.04, 0.025}};
const std::vector<Triangle> slanting{{{{-0.02, -0.01, -0.01}, {0.02, 0.03, 0.01}, {0.01, -0.015, 0.02}}}};

/// A smooth value of each node: curved, so that a wrong node shows.
GuideLattice lattice_around(const std::vector<Triangle>& triangles) {
  const LatticeFrame frame = lattice_frame(box);
  const std::vector<glm::ivec3> nodes = nodes_around(frame, triangles);
  std::vector<glm::vec4> value;
  for (const glm::ivec3& node : nodes) {
    const glm::dvec3 p = frame.place_of(node);
    value.emplace_back(p.x * p.y, p.z + p.y * p.y, 1 - p.x, 3 * p.z - p.y);
  }
  return {frame, nodes, value};
}

std::vector<glm::dvec3> places_on(const Triangle& triangle) {
  const RandomStream stream({3, 0}, "places");
  std::vector<glm::dvec3> places;
  for (std::uint64_t i = 0; i < 500; ++i) {
    double a = stream.uniform(2 * i), b = stream.uniform(2 * i + 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    places.push_back(triangle[0] + a * (triangle[1] - triangle[0]) + b * (triangle[2] - triangle[0]));
  }
  for (const glm::dvec3& corner : triangle) places.push_back(corner);
  return places;
}

TEST(GuideLattice, knows_all_places_of_its_triangles_and_just_around) {
  const GuideLattice lattice = lattice_around(slanting);
  const double beyond = 0.1 * lattice_frame(box).spacing;
  for (const glm::dvec3& p : places_on(slanting[0])) {
    for (int k = 0; k < 6; ++k) {
      glm::dvec3 beside = p;
      beside[k % 3] += k < 3 ? beyond : -beyond;
      EXPECT_TRUE(lattice.at(beside));
    }
    const auto found = lattice.at(p);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, p.x * p.y, 1e-6);
    EXPECT_NEAR(found->y, p.z + p.y * p.y, 1e-6);
    EXPECT_NEAR(found->z, 1 - p.x, 1e-6);
    EXPECT_NEAR(found->w, 3 * p.z - p.y, 1e-6);
  }
}

TEST(GuideLattice, knows_nothing_elsewhere) {
  const GuideLattice lattice = lattice_around(slanting);
  EXPECT_FALSE(lattice.at({-0.02, 0.03, 0}));
  EXPECT_FALSE(lattice.at({10, 0, 0}));
  EXPECT_FALSE(lattice.at({0, -1e30, 0}));
  EXPECT_FALSE(lattice_around({}).at({0, 0, 0}));
}

TEST(GuideLattice, agrees_to_the_bit_with_one_around_other_triangles) {
  std::vector<Triangle> more = slanting;
  more.push_back({{{-0.03, 0, 0}, {0.03, 0, 0}, {0, 0.04, 0.02}}});
  const GuideLattice one = lattice_around(slanting), other = lattice_around(more);
  for (const glm::dvec3& p : places_on(slanting[0])) EXPECT_EQ(one.at(p), other.at(p));
}

TEST(GuideLattice, leaves_shares_and_unknown_places_alone) {
  const GuideLattice lattice = lattice_around(slanting);
  const DetailGuide between{.to_skin = {1, 2, 3}, .layer = 4, .share = {0.5, 0, 0, 0}};
  const glm::dvec3 known = slanting[0][0], unknown(-0.02, 0.03, 0);
  EXPECT_EQ(guide_at(&lattice, known, between).share, between.share);
  EXPECT_EQ(guide_at(&lattice, known, between).to_skin, glm::vec3(*lattice.at(known)));
  EXPECT_EQ(guide_at(&lattice, unknown, between).to_skin, between.to_skin);
  EXPECT_EQ(guide_at(nullptr, known, between).layer, 4.0f);
}

/// Even a box without a size, or a triangle as large as can be, asks for few nodes.
TEST(GuideLattice, stays_small) {
  EXPECT_LE(nodes_around(lattice_frame({{0, 0, 0}, {0, 0, 0}}), slanting).size(), 64u);
  const std::vector<Triangle> huge{{{{-1e3, -1e3, 0}, {1e3, -1e3, 0}, {0, 1e3, 0}}}};
  EXPECT_LE(nodes_around(lattice_frame(box), huge).size(), 3u * 68 * 68);
}

}  // namespace
}  // namespace pomona
