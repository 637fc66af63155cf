// The stencil arms of stored nodes: which are open, which a surface cuts, and where. An arm goes from a node to its
// neighbour along one direction.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/large_memory.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"

namespace pomona {

/// The smallest length of a cut arm (1 = the spacing). A nearer cut is moved to here, so that 1 / theta stays small.
constexpr float min_theta = 1e-5f;

/// The nearest surface along a cut arm, as its node sees it.
struct ArmCut {
  float theta = 0;         ///< length of the arm from the node to the surface, 0..1 (1 = the spacing)
  std::uint32_t side = 0;  ///< 2 * triangle, + 1 for its back
  Color color{0};          ///< colour of that side at the cut, linear
};

/// A node with fewer than six open arms.
struct CutNode {
  std::uint32_t node = 0;       ///< index among the stored nodes
  std::uint32_t first_cut = 0;  ///< index of its first cut; the others follow, sorted by direction
  std::uint8_t cut = 0;         ///< a bit per direction; an arm that is neither open nor cut leads nowhere
};

// The byte of a node: six bits for open arms, one per direction, and two more.
constexpr std::uint8_t all_open = 63;        ///< all six arms are open
constexpr std::uint8_t is_given = 64;        ///< the node is on a patch's border: its value comes from the coarser grid
constexpr std::uint8_t takes_no_part = 128;  ///< the node has no equation

/// The bytes of a block's eight nodes as one word, to test all at once.
constexpr std::uint64_t eight_of(std::uint8_t open) { return 0x0101010101010101u * open; }
inline std::uint64_t eight_at(const std::uint8_t* open) {
  std::uint64_t word = 0;
  std::memcpy(&word, open, sizeof word);
  return word;
}

/// The lowest bits of eight bytes, as one byte. The factor moves the bit of byte k to bit 56 + k; no two collide.
constexpr std::uint8_t lowest_bits(std::uint64_t bytes) {
  return static_cast<std::uint8_t>((bytes & eight_of(1)) * 0x0102040810204080u >> 56);
}

/// A bit for each of a block's eight nodes: whether it is irregular, so that it takes part and has a closed arm.
constexpr std::uint8_t irregular_of(std::uint64_t eight) {
  const std::uint64_t closed = (eight ^ eight_of(all_open)) & eight_of(all_open | is_given);
  return lowest_bits((closed + eight_of(127)) >> 7 & ~(eight >> 7));
}

struct CutArms {
  std::vector<std::uint8_t> open;                      ///< the byte of each stored node; an arm is open from both ends
  std::vector<CutNode, LargeAllocator<CutNode>> node;  ///< the nodes with closed arms, sorted by node
  std::vector<ArmCut, LargeAllocator<ArmCut>> cut;     ///< the cuts of all these nodes, node by node
};

/// Appends the cuts of `parts` to `arms`, in their order.
void append(CutArms& arms, std::vector<CutArms>& parts);

/// The number of bits set in a byte. Baseline x86-64 has no instruction for it.
constexpr std::array<std::uint8_t, 256> bit_counts = [] {
  std::array<std::uint8_t, 256> counts{};
  for (std::size_t i = 1; i < 256; ++i) counts[i] = static_cast<std::uint8_t>(counts[i / 2] + i % 2);
  return counts;
}();

/// For each range of planes, the triangles that may cut arms of it, in their order.
std::vector<std::vector<std::uint32_t>> triangles_by_planes(const SnappedSurfaces& snapped,
                                                            std::span<const std::uint32_t> triangles,
                                                            const Lattice& lattice,
                                                            std::span<const std::pair<int, int>> planes);

/// Finds once which arms of a lattice the surfaces cut. After that, arms() for a selection of nodes is cheap. The
/// result is the same for any number of threads.
class ArmFinder {
 public:
  /// `snapped` and `blocks` must outlive the finder.
  /// \param triangles sorted.
  /// \param members an entry per block, a bit per node: only members have arms.
  ArmFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
            const SparseBlocks& blocks, std::span<const std::uint8_t> members, Threads threads);

  /// The same for all nodes of a lattice, of which `blocks` holds all.
  ArmFinder(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& lattice,
            const SparseBlocks& blocks, Threads threads);

  /// The byte of each node of `blocks`, as in CutArms.
  const std::vector<std::uint8_t>& open() const { return open_; }

  /// For each triangle, the sides that marked nodes see: 1 = front, 2 = back, 3 = both.
  /// \param marked an entry per block, a bit per node.
  std::vector<std::uint8_t> sides_seen(const std::vector<std::uint8_t>& marked) const;

  /// The arms of the nodes that are not marked. Arms to marked nodes must be cut.
  /// \param kept the blocks that hold such nodes.
  CutArms arms(const SparseBlocks& kept, const std::vector<std::uint8_t>& marked) const;

 private:
  ArmFinder(const SnappedSurfaces& snapped, const SparseBlocks& blocks, Threads threads);

  /// open_arms(r, eight bytes) says which arms of a block are open before any surface.
  template <typename OpenArms>
  void find(std::span<const std::uint32_t> triangles, const Lattice& lattice, const OpenArms& open_arms);

  /// Sets the open arms of the kept nodes of a slab, and calls body(node among those kept, its cuts or nothing) for
  /// those with closed ones; arms at a border are closed without a cut.
  template <typename Body>
  void for_irregular(std::size_t i, const SparseBlocks& kept, const std::vector<std::uint8_t>& marked,
                     std::vector<std::uint8_t>& open, const Body& body) const;

  const SnappedSurfaces& snapped_;
  const SparseBlocks& blocks_;
  Threads threads_;
  std::vector<std::uint8_t> open_;
  std::vector<std::pair<std::size_t, std::size_t>> ranges_;  ///< ranges of blocks, some planes each
  std::vector<CutArms> slabs_;                               ///< for each range all nodes with a cut; no `open`
};

}  // namespace pomona
