// Inside or outside, in whole numbers: what both the writer of an asset and its readers count, and must count alike.
#pragma once

#include <cstdint>
#include <vector>

#include "render/page/asset.h"

namespace pomona {

/// How often the boundary (triangles with one hidden side) winds around each node. Rows of nodes along x are walked in
/// quantised positions, on twice the units, so that every sign is exact; where a row meets an edge it passes on the
/// side of larger y, or of larger z, as if moved by a trifle. Closed boundaries give whole numbers everywhere.
std::vector<std::int8_t> windings(const Asset& asset);

/// How many rows of nodes lie within the boxes of the boundary's triangles, all together: the steps that windings()
/// takes.
std::int64_t rows_to_ask(const Asset& asset);

}  // namespace pomona
