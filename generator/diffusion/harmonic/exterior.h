// The air around closed surfaces, which needs no solution.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"

namespace pomona {

/// The nodes that open arms connect with the lattice's first corner: an entry per block, a bit per node.
/// \param blocks all blocks of a lattice
/// \param open as in CutArms
std::vector<std::uint8_t> reached_from_corner(const SparseBlocks& blocks, const std::vector<std::uint8_t>& open,
                                              Threads threads);

/// The blocks with at least one node that is in the lattice and not marked.
SparseBlocks blocks_without(const SparseBlocks& blocks, const std::vector<std::uint8_t>& marked);

}  // namespace pomona
