// The links of stored nodes: which are open, and what the cut ones end on.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/large_memory.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"

namespace pomona {

/// Cuts nearer than this to a node, in links, count as this near: 1 / theta stays a sensible float.
constexpr float least_theta = 1e-5f;

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

/// One bit a direction for open links; one for nodes of a patch's border, whose values come from the coarser grid;
/// and one for nodes that take no part.
constexpr std::uint8_t all_open = 63;
constexpr std::uint8_t is_given = 64;
constexpr std::uint8_t takes_no_part = 128;

/// The links of a run's eight nodes as one word, to be looked at all at once.
constexpr std::uint64_t eight_of(std::uint8_t open) { return 0x0101010101010101u * open; }
inline std::uint64_t eight_at(const std::uint8_t* open) {
  std::uint64_t word = 0;
  std::memcpy(&word, open, sizeof word);
  return word;
}

/// The lowest bits of eight bytes, side by side: the factor brings that of byte k to bit 56 + k, and no two meet.
constexpr std::uint8_t lowest_bits(std::uint64_t bytes) {
  return static_cast<std::uint8_t>((bytes & eight_of(1)) * 0x0102040810204080u >> 56);
}

/// Which of a run's eight nodes have an equation of their own: they take part, and not all six links are open.
constexpr std::uint8_t irregular_of(std::uint64_t eight) {
  const std::uint64_t closed = (eight ^ eight_of(all_open)) & eight_of(all_open | is_given);
  return lowest_bits((closed + eight_of(127)) >> 7 & ~(eight >> 7));
}

struct CutLinks {
  std::vector<std::uint8_t> open;                      ///< per stored node; symmetric
  std::vector<CutNode, LargeAllocator<CutNode>> node;  ///< by node
  std::vector<LinkCut, LargeAllocator<LinkCut>> cut;
};

/// Adds to `links` the cuts of `parts`, one after the other.
void append(CutLinks& links, std::vector<CutLinks>& parts);

/// How many of eight bits are set; the plainest x86-64 has no instruction for it.
constexpr std::array<std::uint8_t, 256> bit_counts = [] {
  std::array<std::uint8_t, 256> counts{};
  for (std::size_t i = 1; i < 256; ++i) counts[i] = static_cast<std::uint8_t>(counts[i / 2] + i % 2);
  return counts;
}();

/// Those of some triangles that may cut links of each of some ranges of planes, in their order.
std::vector<std::vector<std::uint32_t>> triangles_by_planes(const SnappedSurfaces& snapped,
                                                            std::span<const std::uint32_t> triangles,
                                                            const Lattice& lattice,
                                                            std::span<const std::pair<int, int>> planes);

/// The links of a lattice as surfaces cut them, found once for all nodes; the result for those that are wanted then
/// costs little. Same result for any number of threads.
class LinkFinder {
 public:
  /// `snapped` and `runs` must outlive it. `members` has an entry per run, a bit per node: only those have links;
  /// `triangles` ascending.
  LinkFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
             const NodeRuns& runs, std::span<const std::uint8_t> members, Threads threads);

  /// The same for all nodes of a lattice, of which `runs` holds all.
  LinkFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
             const NodeRuns& runs, Threads threads);

  /// Per node of `runs`, as in CutLinks.
  const std::vector<std::uint8_t>& open() const { return open_; }

  /// What each triangle shows to the nodes that are marked (one entry per run, a bit per node): 1 for its front, 2
  /// for its back, 3 for both.
  std::vector<std::uint8_t> sides_seen(const std::vector<std::uint8_t>& marked) const;

  /// The links of the nodes that are not marked; `kept` are the runs that hold some. Links to marked nodes must be cut.
  CutLinks links(const NodeRuns& kept, const std::vector<std::uint8_t>& marked) const;

 private:
  LinkFinder(const SnappedSurfaces& snapped, const NodeRuns& runs, Threads threads);

  /// open_links(r, eight bytes) says which links of a run are open before any surface.
  template <typename OpenLinks>
  void find(std::span<const std::uint32_t> triangles, const Lattice& lattice, const OpenLinks& open_links);

  /// Sets the open links of the kept nodes of a slab, and calls body(node among those kept, its cuts or nothing) for
  /// those with closed ones; links at a border are closed without a cut.
  template <typename Body>
  void for_irregular(std::size_t i, const NodeRuns& kept, const std::vector<std::uint8_t>& marked,
                     std::vector<std::uint8_t>& open, const Body& body) const;

  const SnappedSurfaces& snapped_;
  const NodeRuns& runs_;
  Threads threads_;
  std::vector<std::uint8_t> open_;
  std::vector<std::pair<std::size_t, std::size_t>> ranges_;  ///< of runs: some planes each
  std::vector<CutLinks> slabs_;                              ///< for each range all nodes with a cut; no `open`
};

}  // namespace pomona
