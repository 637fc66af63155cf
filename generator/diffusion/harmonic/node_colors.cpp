#include "generator/diffusion/harmonic/node_colors.h"

#include <utility>

#include "generator/diffusion/harmonic/grid_options.h"
#include "generator/diffusion/harmonic/solve_field.h"

namespace pomona {

namespace {

/// Weights below this are those of nodes from which no walk ends anywhere (field_sampler.cpp).
constexpr float never = 1e-6f;

}  // namespace

NodeColors solved_nodes(const DiffusionSurfaces& surfaces, const HarmonicOptions& options) {
  const GridOptions grid = grid_options(surfaces, options);
  PreparedField prepared = prepared_field(surfaces, grid);
  const SolvedLevels solved = solved_levels(prepared.snapped, std::move(prepared.levels), grid);
  const GridLevel& level = solved.levels[solved.patch_count];

  // Stored nodes come in blocks along x; the others stay unknown.
  NodeColors nodes{.lattice = level.lattice, .color = {}, .known = {}};
  const auto nx = static_cast<std::size_t>(level.lattice.count[0]),
             ny = static_cast<std::size_t>(level.lattice.count[1]);
  nodes.color.assign(nx * ny * static_cast<std::size_t>(level.lattice.count[2]), Color(0));
  nodes.known.assign(nodes.color.size(), 0);
  for (std::size_t r = 0; r < level.blocks.size(); ++r) {
    const NodeBlock& block = level.blocks[r];
    const std::size_t first = (static_cast<std::size_t>(block.z) * ny + static_cast<std::size_t>(block.y)) * nx +
                              static_cast<std::size_t>(block.column) * SparseBlocks::length;
    for (int k = 0; k < level.blocks.inside(r); ++k) {
      const std::size_t node = r * SparseBlocks::length + static_cast<std::size_t>(k);
      const Quad& value = level.value[node];
      if ((level.arms.open[node] & takes_no_part) != 0 || !(value[3] > never)) continue;
      nodes.color[first + static_cast<std::size_t>(k)] = Color(value[0], value[1], value[2]) / value[3];
      nodes.known[first + static_cast<std::size_t>(k)] = 1;
    }
  }
  return nodes;
}

}  // namespace pomona
