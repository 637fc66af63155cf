// Inside or outside, in whole numbers. The writer of an asset and its readers must count alike.
#pragma once

#include <cstdint>
#include <vector>

#include "render/page/asset.h"

namespace pomona {

/// The winding number of the boundary (triangles with one hidden side) around each node. Goes along rows of nodes along
/// x in quantised positions, on twice the units, so that every sign is exact; a row that meets an edge passes on the
/// side of larger y, or of larger z, as if moved slightly. Closed boundaries give whole numbers everywhere.
std::vector<std::int8_t> windings(const Asset& asset);

/// The number of rows of nodes within the boxes of all boundary triangles: the steps of windings().
std::int64_t rows_to_ask(const Asset& asset);

}  // namespace pomona
