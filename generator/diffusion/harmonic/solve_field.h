// From surfaces to a field that can be sampled: grid, stencil arms, levels, solution.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/harmonic/field_sampler.h"
#include "generator/diffusion/harmonic/grid_level.h"
#include "generator/diffusion/harmonic/grid_options.h"

namespace pomona {

/// A field before it is solved.
struct PreparedField {
  SnappedSurfaces snapped;
  std::vector<GridLevel> levels;     ///< the grid that covers everything, then coarser and coarser ones
  CellTriangles triangles;           ///< triangles of each cell of that grid
  std::vector<std::uint32_t> label;  ///< labels of the nodes of the first coarser level, see nearest_labels()
  bool is_sealed = false;            ///< the surfaces are closed, so that the outside has no nodes
};
PreparedField prepared_field(const DiffusionSurfaces& surfaces, const GridOptions& options);

struct SolvedLevels {
  std::vector<GridLevel>
      levels;  ///< patches, the finest first; the grid that covers everything; coarser and coarser ones
  std::size_t patch_count = 0;  ///< number of patches
};

/// Solves a field's levels; adds patches where the grid is too coarse, and solves again. Patches lie around bodies that
/// are small compared with a cell, and where the refinement indicator is large.
SolvedLevels solved_levels(const SnappedSurfaces& snapped, std::vector<GridLevel> levels, const GridOptions& options);

FieldSampler solved_field(PreparedField prepared, const GridOptions& options);

}  // namespace pomona
