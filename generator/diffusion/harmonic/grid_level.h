// One level of the multigrid: nodes, their stencil arms, and Laplace's equation on them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/cut_arms.h"
#include "generator/diffusion/harmonic/large_memory.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/quad.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"

namespace pomona {

/// The equation of a node with closed arms: diagonal * u = source + sum of weight * neighbour over open arms.
struct alignas(64) Stencil {
  Quad source{};                  ///< contribution of the surfaces that cut its arms
  std::array<float, 6> weight{};  ///< per direction; 0 for closed arms
  float inverse = 0;              ///< 1 / diagonal
  float diagonal = 0;
  float odd_inverse = 0;  ///< 1 / the sum of weights along the axes on which the node's coordinate is odd
};

/// The arms of a block's nodes.
struct BlockArms {
  std::int32_t y_down = 0, y_up = 0, z_down = 0, z_up = 0;  ///< offset to the neighbour block, in nodes; 0 = none
  std::uint32_t first_stencil = 0;                          ///< index of the stencil of its first irregular node
  std::uint8_t irregular = 0;                               ///< a bit per node: it has a stencil
  std::uint8_t regular = 0;                                 ///< a bit per node: it has six open arms
  std::uint8_t plain = 0;                                   ///< 1 if all eight nodes are regular
  std::uint8_t parity = 0;                                  ///< parity of y + z
};

struct GridLevel {
  Lattice lattice;
  SparseBlocks blocks;
  CutArms arms;
  std::vector<BlockArms> block_arms;
  RawArray<Stencil> stencil;                                ///< stencils of the irregular nodes, in their order
  std::vector<std::pair<std::size_t, std::size_t>> ranges;  ///< ranges of blocks, some planes each: tasks of threads
  std::vector<std::pair<std::size_t, std::size_t>> planes;  ///< ranges of blocks, one for each plane

  RawArray<Quad> value;     ///< the solution, per node; 0 where a node takes no part
  bool is_patch = false;    ///< it covers a part of the next level; both are solved together
  RawArray<Quad> rhs;       ///< right-hand side without the stencils' sources; empty on the finest level
  RawArray<Quad> residual;  ///< per node; also used as scratch memory

  /// The stencil of an irregular node of a block; arms.node has the same order.
  std::size_t stencil_of(std::size_t block, int k) const {
    return block_arms[block].first_stencil + bit_counts[block_arms[block].irregular & ((1u << k) - 1)];
  }
  std::size_t bytes() const;
};

/// Beyond the lattice's border there is no source of colour: there the solution falls like 1 / r.
/// \param middle r is the distance from here, metres.
GridLevel make_grid_level(const Lattice& lattice, SparseBlocks blocks, CutArms arms, const glm::dvec3& middle,
                          Threads threads);

/// The next coarser level: every other node, with the cuts that its arms inherit.
GridLevel coarser(const GridLevel& fine, const glm::dvec3& middle, Threads threads);

}  // namespace pomona
