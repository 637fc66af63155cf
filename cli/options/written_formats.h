// The formats that each command writes.
#pragma once

#include <vector>

#include "generator/order/option_table.h"

namespace pomona {

/// Of grow, cut and scene. \throws Error (bug) for another taker, which does not write files of all kinds.
const std::vector<Format>& formats_of(OrderTaker taker);

/// Of a solid alone.
const std::vector<Format>& piece_formats();

/// A bare section has no solid to put into a file of meshes.
const std::vector<Format>& section_formats();

}  // namespace pomona
