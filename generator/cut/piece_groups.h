// Which closed parts of a cell form one piece: a cavity wall belongs to the body around it, and overlapping bodies are
// connected (docs/reports/decisions.md).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/cut_piece.h"
#include "generator/cut/section/cross_section.h"

namespace pomona {

/// For every part, the smallest index of the parts that form one piece with it. Only parts of the same cell are
/// grouped. \param cell of each part.
std::vector<std::uint32_t> piece_groups(const std::vector<CutPiece>& parts, const std::vector<std::uint32_t>& cell,
                                        const CrossSection& section);

}  // namespace pomona
