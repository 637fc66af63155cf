// On which side of a stroke triangles lie that are nearer to its corner than the tolerance.
#include "generator/cut/plane/stroke_sides.h"

#include <vector>

#include <gtest/gtest.h>

#include "generator/knife/knife.h"

namespace pomona {
namespace {

/// Two triangles that cut off a corner of the stroke share an edge that follows no facet. If they had different sides,
/// the chain of their other edges would stay open.
TEST(StrokeSides, ConnectedTrianglesOnACornerTakeOneSide) {
  const std::vector<Knife> knives{{PlaneCut(StrokeKnife{{{-2, 0}, {0, 0}, {0, 2}}}), "stroke"}};
  const CutPlanes planes = cut_planes(knives, {glm::dvec3(-1), glm::dvec3(1)});
  const double near = 1.5 * planes.tolerance;
  SplitMesh mesh(planes);
  for (const glm::dvec3& place : {glm::dvec3(-near, 0, 0), {0, near, 0}, {-near, 0, 0.5}, {0, near, -0.5}}) {
    mesh.add_vertex(mesh.add_point(place, 0), {}, {}, {});
  }
  mesh.triangle.resize(2);
  mesh.triangle[0].vertex = {0, 1, 2};
  mesh.triangle[1].vertex = {1, 0, 3};
  DiffusionSurfaces surfaces;
  surfaces.surface = {0};  // both are parts of one triangle
  const StrokeSides sides(mesh, planes, planes.blades[0], surfaces);
  for (const std::size_t positive : {0u, 1u}) {
    const auto is_positive = [&](std::size_t triangle) { return triangle == positive; };
    const int first = positive == 0 ? 1 : -1;
    EXPECT_EQ(sides.of_triangles(is_positive), (std::vector<int>{first, first}));
  }
}

}  // namespace
}  // namespace pomona
