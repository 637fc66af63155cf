#include "tests/cut/carve/arranged_shapes.h"

#include "tests/cut/solid_shapes.h"

namespace pomona::shapes {

namespace {

std::vector<PlaceTriangle> taken(const std::vector<Corners>& triangles, ExactPoints& places) {
  std::vector<PlaceTriangle> all;
  for (const Corners& t : triangles)
    all.push_back({places.number_of(t[0]), places.number_of(t[1]), places.number_of(t[2])});
  return all;
}

}  // namespace

ArrangedShapes::ArrangedShapes(const std::vector<Corners>& fruit_corners, const std::vector<Corners>& knife_corners)
    : fruit(fruit_corners), knife(knife_corners) {
  const std::vector<PlaceTriangle> of_fruit = taken(fruit, places), of_knife = taken(knife, places);
  all = arranged(of_fruit, of_knife, places);
}

std::vector<Corners> corners_of(const ClosedSurface& surface) {
  std::vector<Corners> all;
  for (const glm::uvec3& t : surface.triangle)
    all.push_back({surface.point[t.x], surface.point[t.y], surface.point[t.z]});
  return all;
}

std::vector<FruitAndKnife> fruits_and_knives() {
  std::vector<FruitAndKnife> all;
  for (const std::vector<Corners>& fruit : convex_shapes()) {
    for (const std::vector<Corners>& knife : convex_shapes()) all.push_back({fruit, knife});
  }
  const std::vector<Corners> knife = corners_of(ball({3.1, 2.3, 1.9}, 1.1, 4));
  std::vector<Corners> fruit = corners_of(ball({2, 2, 2}, 1.7, 3));
  all.push_back({fruit, knife});
  const std::vector<Corners> second = corners_of(ball({2.2, 2.9, 2.1}, 1.5, 3));
  fruit.insert(fruit.end(), second.begin(), second.end());
  all.push_back({fruit, knife});
  all.push_back({knife, fruit, false});
  return all;
}

}  // namespace pomona::shapes
