#include "generator/diffusion/harmonic/lattice.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

DiffusionSurfaces long_box() { return shapes::box({-0.3, 0.1, 0.2}, {1.4, 0.5, 0.35}, 3); }

TEST(Lattice, KeepsItsMarginForAnyShift) {
  const DiffusionSurfaces box = long_box();
  const Box<double> bounds = bounds_of(box);
  for (const double shift : {0.0, 0.3, 0.99, 1.7, -0.4}) {
    for (const int margin : {1, 3}) {
      const Lattice lattice = lattice_around(box, 0.1, margin, 3, glm::dvec3(shift, shift / 2, -shift));
      const glm::dvec3 end = shapes::place_of(lattice, lattice.count) - lattice.spacing;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ((lattice.count[static_cast<std::size_t>(axis)] - 1) % 8, 0);
        EXPECT_LE(lattice.origin[axis], bounds.low[axis] - margin * 0.1 + 1e-12);
        EXPECT_GE(end[axis], bounds.high[axis] + margin * 0.1 - 1e-12);
        EXPECT_LT(end[axis] - bounds.high[axis], (margin + 1 + 8) * 0.1);
      }
    }
  }
}

TEST(Lattice, MovesByPartsOfACell) {
  const DiffusionSurfaces box = long_box();
  const glm::dvec3 at_rest = lattice_around(box, 0.1, 1, 3, glm::dvec3(0)).origin;
  const glm::dvec3 moved = lattice_around(box, 0.1, 1, 3, glm::dvec3(0.25, 1.25, -0.75)).origin;
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(at_rest[axis] - moved[axis], 0.025, 1e-12);
}

TEST(Lattice, KeepsItsNodesAndItsUnitWhenHalved) {
  const Lattice lattice = lattice_around(long_box(), 0.1, 1, 4, glm::dvec3(0.3));
  const Lattice fine = halved(lattice), again = doubled(fine);
  EXPECT_EQ(again.count, lattice.count);
  EXPECT_EQ(again.spacing, lattice.spacing);
  EXPECT_EQ(again.unit_bits, lattice.unit_bits);
  EXPECT_EQ(fine.unit(), lattice.unit());
  EXPECT_EQ(fine.units() * 2, lattice.units());
  for (const Node& node : {Node{0, 0, 0}, Node{3, 2, 5}}) {
    const Node twice{2 * node[0], 2 * node[1], 2 * node[2]};
    EXPECT_LT(glm::distance(shapes::place_of(fine, twice), shapes::place_of(lattice, node)), 1e-15);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(fine.count[axis], 2 * lattice.count[axis] - 1);
}

TEST(Lattice, SnapsToTheNearestUnit) {
  const DiffusionSurfaces ball = shapes::sphere(0.37, 5);
  const Lattice lattice = lattice_around(ball, 0.05, 1, 4, glm::dvec3(0.1, 0.7, 0.2));
  const SnappedSurfaces snapped = pomona::snapped(ball, lattice);
  ASSERT_EQ(snapped.position.size(), ball.vertex_count());
  for (std::size_t v = 0; v < ball.vertex_count(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double exact = (static_cast<double>(ball.position[v][axis]) - lattice.origin[axis]) / lattice.unit();
      EXPECT_LE(std::abs(static_cast<double>(snapped.position[v][static_cast<std::size_t>(axis)]) - exact), 0.5);
    }
  }
  EXPECT_EQ(snapped.surfaces, &ball);
}

TEST(Lattice, SnapsANodeOntoItself) {
  const Lattice lattice = shapes::whole_lattice();
  const SnappedSurfaces snapped = pomona::snapped(shapes::surfaces_of(shapes::convex_shapes().front()), lattice);
  for (const auto& p : snapped.position) {
    for (const std::int64_t x : p) EXPECT_TRUE(x == 3 * lattice.units() || x == 5 * lattice.units());
  }
}

}  // namespace
}  // namespace pomona
