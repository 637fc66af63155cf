// Bits of seeds, roots and leaves that hang together with nothing stay with the piece they lie on, so that a half is
// two pieces (docs/reports/decisions.md).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/cut.h"

namespace pomona {

struct StrayBitOptions {
  double largest = 1e-3;  ///< share of the whole's volume up to which a piece is a bit
  double reach = 0.05;    ///< how far from its home a bit may lie, in cube roots of the whole's volume
};

/// For every piece the one it goes with: itself, or, for a bit, the nearest larger piece of its cell within reach.
/// Where a cell has bits alone, the largest of them is the others' home. Distances are those of vertices. \param cell
/// which cell each piece lies in. Pieces without triangles are left alone.
std::vector<std::uint32_t> homes_of_bits(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& cell,
                                         const CrossSection& section, const StrayBitOptions& options = {});

}  // namespace pomona
