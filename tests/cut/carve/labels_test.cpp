#include "generator/cut/carve/labels.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/cut/carve/arranged_shapes.h"
#include "tests/cut/solid_shapes.h"

namespace pomona {
namespace {

using shapes::ArrangedShapes;

/// How far a place is behind all planes of a convex knife that has moved by a small step: above 0 inside it.
double depth_in_moved(const std::vector<Corners>& knife, const glm::dvec3& place) {
  constexpr double e = 1e-4;
  double depth = 1e10;
  for (const Corners& t : knife) {
    const glm::dvec3 front = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
    depth = std::min(depth, glm::dot(front, t[0] + glm::dvec3(e, e * e, e * e * e) - place));
  }
  return depth;
}

/// Where the knife's faces lie in those of the fruit, a part lies inside or outside as if the knife had moved. Returns
/// the number of parts inside.
int expect_labels_of_middles(const ArrangedShapes& shapes) {
  const std::vector<std::vector<int>> winding = windings_of_knife(shapes.all, shapes.places);
  EXPECT_EQ(winding.size(), shapes.all.fruit_count);
  int inside = 0;
  for (std::size_t f = 0; f < winding.size(); ++f) {
    const std::vector<PlaceTriangle>& parts = shapes.all.facet[f].mesh.triangle;
    EXPECT_EQ(winding[f].size(), parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const glm::dvec3 middle =
          (shapes.places.at(parts[k][0]) + shapes.places.at(parts[k][1]) + shapes.places.at(parts[k][2])) / 3.0;
      const double depth = depth_in_moved(shapes.knife, middle);
      EXPECT_EQ(winding[f][k], depth > 0 ? 1 : 0) << depth;
      inside += depth > 0 ? 1 : 0;
    }
  }
  return inside;
}

TEST(Labels, AreThoseOfTheMiddlesOfParts) {
  int inside = 0;
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    if (pair.knife_is_convex) inside += expect_labels_of_middles({pair.fruit, pair.knife});
  }
  EXPECT_GT(inside, 150);
}

/// Labels spread from the first corner of the first facet, which may lie on the knife.
TEST(Labels, AreTheSameWhereverTheyBegin) {
  for (const shapes::FruitAndKnife& pair : shapes::fruits_and_knives()) {
    if (pair.fruit.size() > 12 || !pair.knife_is_convex) continue;
    std::vector<Corners> fruit = pair.fruit;
    for (std::size_t first = 0; first < fruit.size(); ++first) {
      std::rotate(fruit.begin(), fruit.begin() + 1, fruit.end());
      for (int corner = 0; corner < 3; ++corner) {
        std::rotate(fruit[0].begin(), fruit[0].begin() + 1, fruit[0].end());
        expect_labels_of_middles({fruit, pair.knife});
      }
    }
  }
}

TEST(Labels, CountEveryLayerOfAKnife) {
  // Two balls in each other as one knife, and a bar through both of them that no cut of its own ends.
  std::vector<Corners> knife = shapes::corners_of(shapes::ball({0, 0, 0}, 2, 3));
  const std::vector<Corners> core = shapes::corners_of(shapes::ball({0.03, 0.02, 0.01}, 1, 3));
  knife.insert(knife.end(), core.begin(), core.end());
  const ArrangedShapes shapes(shapes::corners_of(shapes::tilted(shapes::block({-3, -0.1, -0.1}, {3, 0.1, 0.1}))),
                              knife);
  const std::vector<std::vector<int>> winding = windings_of_knife(shapes.all, shapes.places);
  std::vector<int> seen(3, 0);
  for (std::size_t f = 0; f < winding.size(); ++f) {
    const std::vector<PlaceTriangle>& parts = shapes.all.facet[f].mesh.triangle;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const glm::dvec3 middle =
          (shapes.places.at(parts[k][0]) + shapes.places.at(parts[k][1]) + shapes.places.at(parts[k][2])) / 3.0;
      const double out = glm::length(middle);
      ++seen.at(static_cast<std::size_t>(winding[f][k]));
      // The balls' faces are flat: their middles lie deeper than their corners.
      const bool is_clear = out < 0.85 || (out > 1.05 && out < 1.7) || out > 2.01;
      if (is_clear) {
        EXPECT_EQ(winding[f][k], out < 1 ? 2 : out < 2 ? 1 : 0) << out;
      }
    }
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

TEST(Labels, AskTheKnifeForWhatItDoesNotMeet) {
  const std::vector<Corners> knife = shapes::corners_of(shapes::ball({0, 0, 0}, 2, 3));
  for (const double x : {0.0, 5.0}) {
    const ArrangedShapes shapes(shapes::corners_of(shapes::ball({x, 0.1, 0}, 0.5, 2)), knife);
    for (const std::vector<int>& of_facet : windings_of_knife(shapes.all, shapes.places))
      EXPECT_EQ(of_facet, std::vector{x == 0 ? 1 : 0});
  }
}

}  // namespace
}  // namespace pomona
