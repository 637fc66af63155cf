// Crossings of arms with surfaces whose corners lie on nodes, against whole numbers.
#include "generator/diffusion/harmonic/crossings.h"

#include <map>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "tests/diffusion/harmonic/whole_shapes.h"

namespace pomona {
namespace {

using Arm = std::tuple<Node, int>;

std::vector<ArmCrossing> crossings_of(const DiffusionSurfaces& surfaces, const Lattice& lattice) {
  return arm_crossings(snapped(surfaces, lattice), shapes::all_triangles(surfaces), lattice, 0, lattice.count[2]);
}

/// An arm is crossed once if exactly one of its ends is inside, else never. For nodes on faces, edges and corners the
/// tie rule decides what is inside.
TEST(Crossings, AreWhereOneEndIsInside) {
  const Lattice lattice = shapes::whole_lattice();
  for (const std::vector<Corners>& shape : shapes::convex_shapes()) {
    std::map<Arm, std::vector<ArmCrossing>> found;
    for (const ArmCrossing& c : crossings_of(shapes::surfaces_of(shape), lattice)) found[{c.node, c.axis}].push_back(c);
    std::size_t crossed = 0;
    for (const Node& node : shapes::nodes_of(lattice)) {
      const bool here = shapes::holds(shape, shapes::place_of(lattice, node));
      for (int axis = 0; axis < 3; ++axis) {
        const Node next = shapes::beside(node, 2 * axis + 1);
        const auto& crossings = found[{node, axis}];
        const bool there = shapes::holds(shape, shapes::place_of(lattice, next));
        if (here == there) {
          // A corner that only touches the arm would count twice, once in each direction.
          int sum = 0;
          for (const ArmCrossing& c : crossings) sum += c.front_ahead ? 1 : -1;
          EXPECT_EQ(sum, 0);
          continue;
        }
        ++crossed;
        ASSERT_EQ(crossings.size(), 1u);
        EXPECT_EQ(crossings[0].front_ahead, here) << "who looks out of it sees backs";
      }
    }
    EXPECT_GT(crossed, 10u);
  }
}

TEST(Crossings, LieOnTheTriangleAndOnTheArm) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::sphere(0.7, 4));
  const Lattice lattice = lattice_around(ball, 0.11, 1, 2, glm::dvec3(0.2, 0.5, 0.7));
  const std::vector<ArmCrossing> found = crossings_of(ball, lattice);
  EXPECT_GT(found.size(), 200u);
  for (const ArmCrossing& c : found) {
    glm::dvec3 on_arm = shapes::place_of(lattice, c.node);
    on_arm[c.axis] += static_cast<double>(c.theta) * lattice.spacing;
    const glm::uvec3& t = ball.triangle[c.triangle];
    glm::dvec3 on_triangle(0);
    for (int k = 0; k < 3; ++k) {
      const double weight = c.weight[static_cast<std::size_t>(k)];
      EXPECT_GE(weight, 0);
      on_triangle += weight * glm::dvec3(ball.position[t[k]]);
    }
    EXPECT_LT(glm::distance(on_arm, on_triangle), 2e-7);
    EXPECT_GE(c.theta, 0);
    EXPECT_LE(c.theta, 1);
    const glm::dvec3 a(ball.position[t.x]), b(ball.position[t.y]), d(ball.position[t.z]);
    EXPECT_EQ(c.front_ahead, glm::cross(b - a, d - a)[c.axis] > 0);
  }
}

/// Corners and middles of these triangles are nodes. Where a triangle passes through a node, sums of thirds may be
/// rounded to either side.
TEST(Crossings, LieOnTheirArmEvenWhereItsEndIsInTheTriangle) {
  const Lattice lattice{.origin = glm::dvec3(0), .spacing = 1, .count = {64, 64, 64}, .unit_bits = 4};
  const RandomStream random({}, "tests/triangles through nodes");
  std::vector<Corners> triangles(200);
  std::uint64_t drawn = 0;
  for (Corners& t : triangles) {
    for (glm::dvec3& corner : t) {
      for (int axis = 0; axis < 3; ++axis) corner[axis] = 3.0 * static_cast<double>(random.below(drawn++, 21));
    }
  }
  int at_nodes = 0;
  for (const ArmCrossing& c : crossings_of(shapes::surfaces_of(triangles), lattice)) {
    EXPECT_GE(c.theta, 0);
    EXPECT_LE(c.theta, 1);
    at_nodes += c.theta < 1e-9f || c.theta == 1;
  }
  EXPECT_GT(at_nodes, 200);
}

TEST(Crossings, OfSomePlanesAreThoseWithAnEndThere) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::sphere(0.7, 4));
  const Lattice lattice = lattice_around(ball, 0.11, 1, 2, glm::dvec3(0.2, 0.5, 0.7));
  const std::vector<std::uint32_t> all = shapes::all_triangles(ball);
  const auto same = [](const ArmCrossing& a, const ArmCrossing& b) {
    return std::tie(a.triangle, a.node, a.axis, a.theta) == std::tie(b.triangle, b.node, b.axis, b.theta);
  };
  for (const auto& [first, end] : {std::pair{0, 3}, {3, 8}, {8, lattice.count[2]}}) {
    std::vector<ArmCrossing> wanted;
    for (const ArmCrossing& c : crossings_of(ball, lattice)) {
      const bool begins = c.node[2] >= first && c.node[2] < end;
      const bool ends = c.axis == 2 && c.node[2] + 1 >= first && c.node[2] + 1 < end;
      if (begins || ends) wanted.push_back(c);
    }
    const std::vector<ArmCrossing> found = arm_crossings(snapped(ball, lattice), all, lattice, first, end);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_TRUE(same(found[i], wanted[i])) << i;
    EXPECT_GT(found.size(), 20u);
  }
}

}  // namespace
}  // namespace pomona
