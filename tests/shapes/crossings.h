// Where surfaces cross each other, and themselves.
#pragma once

#include <map>
#include <utility>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Pairs of triangles that cross, by surface. Surfaces consist of pieces, connected parts: a chamber in each fold.
struct Crossings {
  std::map<std::pair<int, int>, int> between;  ///< two pieces; equal surfaces for two pieces of one
  std::map<int, int> within;                   ///< a piece through itself

  bool empty() const { return between.empty() && within.empty(); }
};

/// Pairs of triangles that cross properly: an edge of one goes through the inside of the other. Decided exactly, for
/// the positions as they are in floats. Touching, a shared edge, and overlapping in one plane do not count.
Crossings crossing_triangles(const DiffusionSurfaces& surfaces);

}  // namespace pomona
