#include "generator/scene/settle/piece_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/units.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/mesh/weld.h"
#include "generator/scene/settle/surface_samples.h"
#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

std::vector<Solid> shapes() {
  return {heap_shapes::ball(0.02), heap_shapes::wedge(0.03, 70), heap_shapes::ring(0.035, 0.029, 0.006)};
}

/// Random points in the box around a shape, enlarged by a tenth.
std::vector<glm::vec3> points_about(const PieceShape& shape) {
  const RandomStream draw({5, 0}, "tests/points");
  const glm::vec3 size = 1.1f * shape.box.size(), low = shape.box.center() - 0.5f * size;
  std::vector<glm::vec3> points;
  for (std::uint64_t i = 0; i < 3000; i += 3)
    points.push_back(low + size * glm::vec3(draw.uniform(i), draw.uniform(i + 1), draw.uniform(i + 2)));
  return points;
}

TEST(PieceShape, ABallWeighsWhatItsMeshBounds) {
  const PieceShape shape = piece_shape(heap_shapes::ball(0.02), 0.035);
  const double mass = 4.0 / 3 * pi * 0.02 * 0.02 * 0.02;
  EXPECT_NEAR(shape.mass, mass, 0.02 * mass);
  EXPECT_LT(glm::length(shape.center), 1e-6);
  EXPECT_NEAR(1 / shape.inverse_inertia[0][0], 0.4 * mass * 0.02 * 0.02, 0.05 * 0.4 * mass * 0.02 * 0.02);
}

/// A needle is so thin that the addition to its inertia matters.
TEST(PieceShape, ANeedleWeighsTheSameWhetherByItsMeshOrByWhatIsInside) {
  Solid needle = heap_shapes::slab({0.1, 0.002, 0.002});
  const PieceShape by_mesh = piece_shape(needle, 0.05);
  const glm::dvec3 squared(0.1 * 0.1, 0.002 * 0.002, 0.002 * 0.002);
  const double mass = 1050 * 0.1 * 0.002 * 0.002;
  glm::dmat3 inertia(0);
  for (int i = 0; i < 3; ++i) inertia[i][i] = mass / 12 * (squared.x + squared.y + squared.z - squared[i]);
  needle.density = 1050;
  needle.weighed = RigidMass{mass, by_mesh.center, inertia};
  const PieceShape by_parts = piece_shape(needle, 0.05);
  EXPECT_NEAR(by_parts.mass / by_mesh.mass, 1, 1e-5);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(by_parts.inverse_inertia[i][i] / by_mesh.inverse_inertia[i][i], 1, 1e-3) << i;
}

/// The round side of a peeled wedge is larger than either flat side, but must not be the one that is shown.
TEST(PieceShape, AFlatCutFaceIsShownBeforeARoundOne) {
  Solid wedge = heap_shapes::wedge(0.03, 70);
  std::map<std::array<long, 3>, double> area_by_normal;
  const auto area_of = [&](const glm::uvec3& t) {
    const glm::dvec3 a(wedge.mesh.position[t.x]), b(wedge.mesh.position[t.y]), c(wedge.mesh.position[t.z]);
    return glm::cross(b - a, c - a);
  };
  const auto direction = [&](const glm::uvec3& t) {
    const glm::dvec3 n = glm::normalize(area_of(t)) * 1e3;
    return std::array{std::lround(n.x), std::lround(n.y), std::lround(n.z)};
  };
  for (const glm::uvec3& t : wedge.mesh.triangle) area_by_normal[direction(t)] += glm::length(area_of(t));
  std::vector<std::pair<double, std::array<long, 3>>> sides;
  for (const auto& [normal, area] : area_by_normal) sides.emplace_back(area, normal);
  std::sort(sides.rbegin(), sides.rend());

  wedge.mesh.cut_face.assign(wedge.mesh.triangle.size(), 2);  // the round side
  for (std::size_t i = 0; i < wedge.mesh.triangle.size(); ++i)
    for (int side = 0; side < 2; ++side)
      if (direction(wedge.mesh.triangle[i]) == sides[static_cast<std::size_t>(side)].second)
        wedge.mesh.cut_face[i] = side;
  double best = 0;
  for (int side = 0; side < 2; ++side) {
    const auto& n = sides[static_cast<std::size_t>(side)].second;
    best = std::max(best, glm::dot(piece_shape(wedge, 0.05).up, 1e-3 * glm::dvec3(n[0], n[1], n[2])));
  }
  EXPECT_GT(best, 0.99);

  wedge.mesh.cut_face.assign(wedge.mesh.triangle.size(), -1);
  EXPECT_EQ(piece_shape(wedge, 0.05).up, glm::dvec3(0)) << "nothing was cut";
}

TEST(PieceShape, ShowsTheSameFaceWhereverThePieceLies) {
  Solid slab = heap_shapes::slab({0.1, 0.03, 0.06});
  slab.mesh.cut_face.assign(slab.mesh.triangle.size(), -1);
  for (std::size_t i = 0; i < slab.mesh.triangle.size(); ++i) {
    const glm::uvec3& t = slab.mesh.triangle[i];
    const glm::dvec3 a(slab.mesh.position[t.x]), b(slab.mesh.position[t.y]), c(slab.mesh.position[t.z]);
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (int axis = 0; axis < 3; ++axis)
      if (normal[axis] > 0.99) slab.mesh.cut_face[i] = axis;
  }
  for (const glm::vec3& by : {glm::vec3(0), {0.5f, 0, 0}, {0, -0.5f, 0}, {0, 0, 0.5f}, {-0.3f, 0.2f, 0.4f}}) {
    Solid moved = slab;
    for (glm::vec3& p : moved.mesh.position) p += by;
    EXPECT_LT(glm::distance(piece_shape(moved, 0.05).up, {0, 1, 0}), 1e-5) << by.x << ' ' << by.y << ' ' << by.z;
  }
}

TEST(PieceShape, TheGridKnowsDistancesToTheRealMesh) {
  for (const Solid& solid : shapes()) {
    const PieceShape shape = piece_shape(solid, 0.05);
    const TriangleTree tree(solid.mesh.position, solid.mesh.triangle);
    for (const glm::vec3& p : points_about(shape)) {
      const glm::dvec3 there = glm::dvec3(p) + shape.center;
      const double distance = (tree.contains(there) ? -1 : 1) * tree.nearest(there).distance;
      EXPECT_NEAR(shape.distance.value(p), distance, 0.015 * shape.size) << solid.name;
    }
  }
}

TEST(PieceShape, SamplesLieOnTheSurfaceAndInTheirBalls) {
  for (const Solid& solid : shapes()) {
    const PieceShape shape = piece_shape(solid, 0.05);
    ASSERT_GT(shape.samples.point.size(), 50u) << solid.name;
    const TriangleTree tree(solid.mesh.position, solid.mesh.triangle);
    for (const glm::vec3& p : shape.samples.point)
      EXPECT_LT(tree.nearest(glm::dvec3(p) + shape.center).distance, 1e-6) << solid.name;
    int covered = 0;
    for (const SampleBall& ball : shape.samples.ball) {
      covered += ball.count;
      for (int i = ball.first; i < ball.first + ball.count; ++i)
        EXPECT_LE(glm::distance(shape.samples.point[static_cast<std::size_t>(i)], ball.center), ball.radius * 1.0001f);
    }
    EXPECT_EQ(covered, std::ssize(shape.samples.point)) << solid.name;
  }
}

/// All twelve edges of a box are right angles, and the diagonals of its sides are flat.
TEST(SurfaceSamples, LieAtTheEndsAndTheMiddleOfEverySharpEdge) {
  const Solid slab = heap_shapes::slab({0.1, 0.03, 0.06});
  const std::vector<glm::dvec3> corner(slab.mesh.position.begin(), slab.mesh.position.end());
  const std::vector<std::uint32_t> first = weld(slab.mesh.position);
  const std::vector<glm::uvec3> triangle = welded_triangles(first, slab.mesh.triangle);
  const SurfaceSamples samples = surface_samples(corner, triangle, {.along_edges = 1e-4, .elsewhere = 1});
  const auto is_sampled = [&](const glm::dvec3& place) {
    return std::any_of(samples.point.begin(), samples.point.end(),
                       [&](const glm::vec3& p) { return glm::distance(glm::dvec3(p), place) < 1e-7; });
  };
  int edges = 0, diagonals = 0;
  for (const glm::uvec3& t : triangle) {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 &a = corner[t[i]], &b = corner[t[(i + 1) % 3]], way = b - a;
      const bool is_edge = (way.x != 0) + (way.y != 0) + (way.z != 0) == 1;
      (is_edge ? edges : diagonals) += 1;
      EXPECT_EQ(is_sampled(0.5 * (a + b)), is_edge);
      EXPECT_TRUE(is_sampled(a) && is_sampled(b));
    }
  }
  EXPECT_EQ(edges, 24);
  EXPECT_EQ(diagonals, 12);
}

}  // namespace
}  // namespace pomona
