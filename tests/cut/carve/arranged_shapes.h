// A fruit and a closed knife in an arrangement, as carving has them.
#pragma once

#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/knife/knife.h"
#include "tests/cut/carve/moved_knife.h"

namespace pomona::shapes {

struct ArrangedShapes {
  /// Corners at one place become one place, and edges common edges.
  ArrangedShapes(const std::vector<Corners>& fruit_corners, const std::vector<Corners>& knife_corners);

  std::vector<Corners> fruit, knife;
  ExactPlaces places;
  Arrangement all;
};

std::vector<Corners> corners_of(const ClosedSurface& surface);

/// Fruits and knives that touch in corners, edges and faces, all closed and convex; then balls in general position, and
/// a fruit of two balls that pass through each other on the knife.
struct FruitAndKnife {
  std::vector<Corners> fruit, knife;
};
std::vector<FruitAndKnife> fruits_and_knives();

}  // namespace pomona::shapes
