// Which closed parts of a cell are one piece: a cavity wall belongs to what surrounds it, and bodies that overlap hang
// together (docs/reports/decisions.md).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/cut.h"

namespace pomona {

/// For every part the smallest index among the parts it forms one piece with. `cell` tells which cell a part lies in:
/// only parts of one cell come together.
std::vector<std::uint32_t> piece_groups(const std::vector<CutPiece>& parts, const std::vector<std::uint32_t>& cell,
                                        const CrossSection& section);

}  // namespace pomona
