// A fruit and a closed knife, arranged as carving does it.
#pragma once

#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/knife/knife.h"
#include "tests/cut/carve/moved_knife.h"

namespace pomona::shapes {

struct ArrangedShapes {
  /// Corners at one place become one point, and their edges common edges.
  ArrangedShapes(const std::vector<Corners>& fruit_corners, const std::vector<Corners>& knife_corners);

  std::vector<Corners> fruit, knife;
  ExactPoints places;
  Arrangement all;
};

std::vector<Corners> corners_of(const ClosedSurface& surface);

struct FruitAndKnife {
  std::vector<Corners> fruit, knife;
  bool knife_is_convex = true;
};

/// Closed shapes: convex ones that touch in corners, edges and faces; balls in general position; two balls that pass
/// through each other, first as a fruit and then as a knife.
std::vector<FruitAndKnife> fruits_and_knives();

}  // namespace pomona::shapes
