// Small bits of seeds, roots and leaves that are not connected with anything stay with the piece on which they lie, and
// so do the leaves of a head, so that a halved fruit is two pieces (docs/reports/decisions.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/cut/cut_piece.h"
#include "generator/cut/section/cross_section.h"

namespace pomona {

struct StrayBitOptions {
  double largest = 1e-3;  ///< a piece with at most this share of the whole's volume is a bit
  double reach = 0.05;    ///< largest distance of a bit from its home, in cube roots of the whole's volume
};

/// The home of every piece: the piece itself, or, for a bit, the nearest larger piece of its cell within reach. If a
/// cell contains only bits, the largest of them is the home of the others. Distances are measured between vertices.
/// Pieces without triangles are ignored. \param cell of each piece.
std::vector<std::uint32_t> homes_of_bits(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& cell,
                                         const CrossSection& section, const StrayBitOptions& options = {});

/// The home of every piece: the piece itself, or, for one whose skin consists of held parts alone, the piece that it
/// lies against, directly or by others of its kind: at most `reach` away, in cube roots of the whole's volume, nearest
/// ones first, measured between triangles. Of held ones that lie against each other alone, the largest is the home.
/// \param cell of each piece.
std::vector<std::uint32_t> homes_of_held(const std::vector<CutPiece>& pieces, const std::vector<std::uint32_t>& cell,
                                         const CrossSection& section, std::span<const int> held_parts,
                                         double reach = 0.08);

}  // namespace pomona
