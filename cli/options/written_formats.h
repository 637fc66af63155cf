// The formats that each command writes.
#pragma once

#include <vector>

#include "generator/order/option_table.h"

namespace pomona {

/// The formats of grow, cut and scene. \throws Error (bug) for other commands.
const std::vector<Format>& formats_of(OrderTaker taker);

/// The formats of a single solid.
const std::vector<Format>& piece_formats();

/// The formats of a bare section, which has no solid for files of meshes.
const std::vector<Format>& section_formats();

}  // namespace pomona
