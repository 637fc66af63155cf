// The parts of a scene before they have poses.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/base/error.h"
#include "generator/piece/pose.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/settle.h"

namespace pomona {

/// Measurements for --stats.
struct ComposeReport {
  std::vector<std::pair<std::string, double>> stages;  ///< milliseconds, summed over threads, in the road's order
  std::map<std::string, std::int64_t> counts;
  std::vector<std::string> warnings;
  std::vector<Fit> fits;  ///< fit of every piece; empty for a layout from a file
};

/// A placed dish.
struct ScenePlacedDish {
  std::string name;
  int solid = 0;        ///< index; dishes that are made alike share one
  Pose pose{};          ///< its pose; it only turns about the vertical
  int part_of = -1;     ///< index of the dish in or on which it stands; -1 = none
  bool turned = true;   ///< it is a solid of revolution
  SourcePlace place{};  ///< its place in the scene file
};

/// Everything a scene consists of, not yet placed. Equal pieces share one solid.
struct SceneParts {
  std::vector<Solid> solids;            ///< solids of the pieces, then of the dishes
  std::vector<SettleItem> items;        ///< named items to place; solids and arrangements by index
  std::vector<int> dish_of;             ///< index of the dish of each item; -1 = the ground
  std::vector<ScenePlacedDish> dishes;  ///< the bowl is the first, where there is one
  std::vector<PieceArrangement> arrangements;
  ComposeReport report;
};

}  // namespace pomona
