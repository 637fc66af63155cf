// The links of stored nodes: which are open, and what the cut ones end on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"
#include "generator/diffusion/harmonic/quad.h"

namespace pomona {

/// The nearest surface along a cut link, as its node sees it.
struct LinkCut {
  float theta = 0;         ///< distance in links, 0..1
  std::uint32_t side = 0;  ///< 2 * triangle, + 1 for its back
  Color color{0};          ///< of that side, there
};

/// A node with fewer than six open links.
struct CutNode {
  std::uint32_t node = 0;       ///< among the stored ones
  std::uint32_t first_cut = 0;  ///< its cuts, by direction
  std::uint8_t cut = 0;         ///< a bit per direction; links neither open nor cut lead to nowhere
};

/// One bit a direction for open links, and one for nodes that take no part.
constexpr std::uint8_t all_open = 63;
constexpr std::uint8_t takes_no_part = 128;

struct CutLinks {
  std::vector<std::uint8_t> open;  ///< per stored node; symmetric
  std::vector<CutNode> node;       ///< by node
  std::vector<LinkCut> cut;
};

/// The triangles that may cut links of each of some ranges of planes, in their order.
std::vector<std::vector<std::uint32_t>> triangles_by_planes(const SnappedSurfaces& snapped, const Lattice& lattice,
                                                            std::span<const std::pair<int, int>> planes);

/// Same result for any number of threads.
CutLinks make_cut_links(const SnappedSurfaces& snapped, const Lattice& lattice, const NodeRuns& runs, Threads threads);

/// The links of every other node: open where both halves are, else cut where the nearer half is.
CutLinks coarser_links(const CutLinks& fine, const NodeRuns& fine_runs, const NodeRuns& coarse_runs, Threads threads);

}  // namespace pomona
