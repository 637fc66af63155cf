// Options of a page, and how its scripts get them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/knife/knife.h"
#include "render/style/style.h"

namespace pomona {

/// Limit of cuts of a page.
constexpr std::size_t max_page_cuts = 4;

/// A plane that a page opens with. Those of one knife follow one another; `step` is by how much the number of the
/// knife's cell grows beyond the plane, and 0 of wedges, whose cells are counted by their angle
/// (generator/knife/knife_planes.h): of cells with equally much of a spared part, the first in this order has it.
struct PageCut {
  CuttingPlane plane;
  int knife = 0, step = 1;
};

struct PageOptions {
  Style style;
  std::vector<PageCut> cuts;  ///< opening cuts; at most max_page_cuts
  std::string made_by;        ///< "pomona 0.3.0, seed 2"
};

}  // namespace pomona
