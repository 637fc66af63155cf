// One level of the multigrid: nodes, their links, and Laplace's equation on them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/cut_links.h"
#include "generator/diffusion/harmonic/large_memory.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"
#include "generator/diffusion/harmonic/quad.h"

namespace pomona {

/// The equation of a node with closed links: diagonal * u = source + sum of weight * neighbour over open links.
struct alignas(64) Stencil {
  Quad source{};  ///< what the surfaces give
  std::array<float, 6> weight{};
  float inverse = 0;  ///< of the diagonal
  float diagonal = 0;
  float odd_inverse = 0;  ///< of the sum of weights along axes where the node's coordinate is odd
};

/// A node's links, by run: offsets to the same place in the runs beside, 0 where there is none.
struct RunLinks {
  std::int32_t y_down = 0, y_up = 0, z_down = 0, z_up = 0;  ///< in nodes
  std::uint32_t first_stencil = 0;
  std::uint8_t irregular = 0;  ///< a bit per node: it has a stencil
  std::uint8_t regular = 0;    ///< a bit per node: it has six open links
  std::uint8_t plain = 0;      ///< 1 if all eight nodes have
  std::uint8_t parity = 0;     ///< of y + z
};

struct GridLevel {
  Lattice lattice;
  NodeRuns runs;
  CutLinks links;
  std::vector<RunLinks> run_links;
  RawArray<Stencil> stencil;
  std::vector<std::pair<std::size_t, std::size_t>> ranges;  ///< of runs, for threads: some planes each
  std::vector<std::pair<std::size_t, std::size_t>> planes;  ///< of runs, one plane each

  RawArray<Quad> value;     ///< what is sought; 0 where a node takes no part
  bool is_patch = false;    ///< covers a part of the next level, which is solved together with it
  RawArray<Quad> rhs;       ///< besides the stencils' sources; empty on the finest level
  RawArray<Quad> residual;  ///< scratch too

  /// The stencil of an irregular node of a run; links.node has the same order.
  std::size_t stencil_of(std::size_t run, int k) const {
    return run_links[run].first_stencil + bit_counts[run_links[run].irregular & ((1u << k) - 1)];
  }
  std::size_t bytes() const;
};

/// What lies beyond the lattice's border: nothing that gives colour, so that the solution falls like 1 / r, r from
/// `middle` (metres).
GridLevel make_grid_level(const Lattice& lattice, NodeRuns runs, CutLinks links, const glm::dvec3& middle,
                          Threads threads);

/// Every other node, with the links that it inherits.
GridLevel coarser(const GridLevel& fine, const glm::dvec3& middle, Threads threads);

}  // namespace pomona
