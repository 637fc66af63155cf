// Levels of detail: the same solid with half its triangles, with a quarter of them, ..., for what is seen from afar.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/piece/solid.h"

namespace pomona {

struct LodOptions {
  int levels = 1;  ///< 1..6: a half, a quarter, ... of the triangles

  // Of level 1; each further one may stray by the root of two more: seen from where it serves, it strays by as much.
  double error = 0.005;       ///< how far surface and borders may stray, in diagonals of the solid's bounding box
  double color_error = 0.05;  ///< how far a channel of a colour may, 0..1, of the square root of linear light

  Threads threads{};  ///< for many solids
};

/// Coarser and coarser, named "<name>_LOD1", "<name>_LOD2", ... Every vertex is one of the solid's, with all its
/// attributes: cut faces stay in their planes, and colours in their range. What is closed stays closed, no triangle
/// turns over, and each vertex that is gone lies within the error of the level's surface, and of its border if it lay
/// on one. Where that takes more triangles than asked for, a level has them; where it leaves nothing to take away,
/// levels end early. The same bytes on any machine. \throws Error (usage) for a number of levels or an error that is
/// none.
std::vector<Solid> levels_of_detail(const Solid& solid, const LodOptions& options = {});

/// Of many solids: one entry for each.
std::vector<std::vector<Solid>> all_levels_of_detail(std::span<const Solid> solids, const LodOptions& options = {});

}  // namespace pomona
