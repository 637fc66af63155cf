// Air around closed surfaces, which needs no solution.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/node_runs.h"

namespace pomona {

/// The nodes to which open links lead from the lattice's first corner: an entry per run, a bit per node.
/// \param runs all of a lattice
/// \param open as in CutLinks
std::vector<std::uint8_t> reached_from_corner(const NodeRuns& runs, const std::vector<std::uint8_t>& open,
                                              Threads threads);

/// The runs that hold a node which is neither marked nor beyond the lattice.
NodeRuns runs_without(const NodeRuns& runs, const std::vector<std::uint8_t>& marked);

}  // namespace pomona
