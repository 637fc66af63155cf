// Settling: pieces fall into a bowl until they are at rest.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generator/piece/pose.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/fit_check.h"
#include "generator/scene/settle/settle_options.h"

namespace pomona {

struct Settled {
  std::vector<Pose> poses;  ///< one per item, rounded to 1e-6 so that a file holds them exactly
  std::vector<Fit> fits;    ///< one per item, measured at those poses
  int attempts = 0;         ///< number of attempts that were made
  int steps = 0;            ///< number of steps of the simulation
  std::size_t again = 0;    ///< number of times that a single piece was removed and dropped again
};

/// Places the items that an arrangement places. Then drops the others into the dish, in random order and from random
/// places, which follow from the seed. The dish stands on the ground (y = 0) and does not move; without a dish, pieces
/// fall onto the ground. The poses are the same for any number of threads. Several heaps may settle at the same time.
/// \throws Error (some_items_failed) that names the pieces with a gap, with an overlap, or outside the dish; (bad_data)
/// if the dish has no room: no hollow, or no triangle that faces upwards to scatter pieces on.
Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
               const SettleOptions& options = {});

}  // namespace pomona
