// Levels of detail: the same solid with a half, a quarter, ... of its triangles, for views from far away.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/piece/solid.h"

namespace pomona {

struct LodOptions {
  int levels = 1;  ///< number of levels, 1..6: a half, a quarter, ... of the triangles

  // The errors are those of level 1. They grow by the square root of two per level; seen from the distance at which a
  // level is used, they look equal.
  double error = 0.005;       ///< error of the surface and its borders, in diagonals of the solid's bounding box
  double color_error = 0.05;  ///< largest error of a channel, 0..1, of the square root of linear light

  Threads threads{};  ///< for many solids
};

/// Coarser and coarser levels, named "<name>_LOD1", "<name>_LOD2", ... Every vertex is a vertex of the solid, with all
/// its attributes: cut faces stay in their planes, and colours in their range. A closed solid stays closed, and no
/// triangle turns over. Each removed vertex is within the error of the level's surface, and of its border if it was on
/// one. A level has more triangles than asked for if that is needed; levels end early if nothing more can be removed.
/// The bytes are the same on any machine.
/// \throws Error (usage) for an invalid number of levels or an invalid error.
std::vector<Solid> levels_of_detail(const Solid& solid, const LodOptions& options = {});

/// The levels of many solids, one entry for each.
std::vector<std::vector<Solid>> all_levels_of_detail(std::span<const Solid> solids, const LodOptions& options = {});

}  // namespace pomona
