#include "generator/mesh/distance_tree.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"
#include "tests/mesh/random_points.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

TriangleTree tree_of(const DiffusionSurfaces& surfaces) { return {surfaces.position, surfaces.triangle}; }

/// The least distance that nearest_on_triangle() finds, triangle by triangle.
double distance_by_trying_all(const TriangleTree& tree, const glm::dvec3& p) {
  double min = std::numeric_limits<double>::infinity();
  for (const TriangleTree::Corners& t : tree.triangles()) {
    const glm::dvec3 away = nearest_on_triangle(p, t) - p;
    min = std::min(min, glm::dot(away, away));
  }
  return std::sqrt(min);
}

/// Points inside, outside, far away, and on the mesh itself.
std::vector<glm::dvec3> places_around(const TriangleTree& tree) {
  std::vector<glm::dvec3> places = random_points(400, 3);
  for (const glm::dvec3& p : random_points(50, 3)) places.push_back(200.0 * p);
  for (std::size_t t = 0; t < tree.triangles().size(); t += 7) {
    const TriangleTree::Corners& c = tree.triangles()[t];
    places.insert(places.end(), {c[0], 0.5 * (c[0] + c[1]), (c[0] + c[1] + c[2]) / 3.0});
  }
  return places;
}

TEST(DistanceTree, MeasuresToTheBitWhatTryingAllTrianglesDoes) {
  for (const DiffusionSurfaces& mesh :
       {shapes::torus(2, 0.7, 24, 12), shapes::sphere(0.04, 32), shapes::sphere(1, 3)}) {
    const TriangleTree tree = tree_of(mesh);
    const std::vector<glm::dvec3> places = places_around(tree);
    const std::vector<double> distances = DistanceTree(tree).distances(places);
    for (std::size_t i = 0; i < places.size(); ++i)
      EXPECT_EQ(distances[i], distance_by_trying_all(tree, places[i])) << i;
  }
}

TEST(DistanceTree, GoesNoFartherThanAsked) {
  const TriangleTree tree = tree_of(shapes::torus(2, 0.7, 24, 12));
  const DistanceTree packed(tree);
  const std::vector<glm::dvec3> places = places_around(tree);
  const std::vector<double> all = packed.distances(places), near = packed.distances(places, 0.3);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(near[i], std::min(all[i], 0.3));
    EXPECT_EQ(packed.nearest(places[i], 0.3).distance, all[i] < 0.3 ? all[i] : std::numeric_limits<double>::infinity());
  }
}

TEST(DistanceTree, KnowsTheSameOnAnyNumberOfThreadsAndInAnyOrder) {
  const DistanceTree packed(tree_of(shapes::torus(2, 0.7, 48, 24)));
  std::vector<glm::dvec3> places = random_points(3000, 3);
  const std::vector<double> one = packed.distances(places, 1, {1});
  EXPECT_EQ(packed.distances(places, 1, {3}), one);
  std::reverse(places.begin(), places.end());
  std::vector<double> backwards = packed.distances(places, 1, {2});
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(backwards, one);
}

TEST(DistanceTree, FindsNothingWhereThereIsNothing) {
  const DistanceTree none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.nearest({1, 2, 3}).distance, std::numeric_limits<double>::infinity());
  EXPECT_EQ(none.distances(random_points(3, 1), 5), std::vector<double>(3, 5.0));
}

}  // namespace
}  // namespace pomona
