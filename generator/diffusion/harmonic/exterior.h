// Air around closed surfaces, which needs no solution.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/cut_links.h"

namespace pomona {

/// For each stored node of a whole lattice whether open links lead from the lattice's border to it (1 or 0). All 0
/// if those nodes see a triangle from both sides: then some surface there is open, and what is behind it counts
/// like what is before it.
std::vector<std::uint8_t> sealed_off(const CutLinks& links, const NodeRuns& runs, std::size_t triangle_count);

/// The same nodes and links without those that `is_left_out`; links into what is left out must be cut.
std::pair<NodeRuns, CutLinks> without(const NodeRuns& runs, const CutLinks& links,
                                      const std::vector<std::uint8_t>& is_left_out);

}  // namespace pomona
