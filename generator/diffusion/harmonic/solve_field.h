// From surfaces to a field that can be asked: grid, links, levels, solution.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/harmonic/field_look_up.h"
#include "generator/diffusion/harmonic/grid_level.h"
#include "generator/diffusion/harmonic/grid_options.h"

namespace pomona {

/// Levels ready to be solved.
struct PreparedField {
  SnappedSurfaces snapped;
  std::vector<GridLevel> levels;  ///< the grid that holds all; ever coarser ones
  CellTriangles triangles;
  std::vector<std::uint32_t> label;  ///< of the first coarser level's nodes, see nearest_labels()
  bool is_sealed = false;            ///< closed surfaces keep the outside out: it has no nodes
};
PreparedField prepared_field(const DiffusionSurfaces& surfaces, const GridOptions& options);

struct SolvedLevels {
  std::vector<GridLevel> levels;  ///< patches, the finest first; the grid that holds all; ever coarser ones
  std::size_t patch_count = 0;
};

/// Solves a field's levels, lays patches where they are too coarse, and goes on with these: around bodies that are
/// small for the grid, and where its solution bends.
SolvedLevels solved_levels(const SnappedSurfaces& snapped, std::vector<GridLevel> levels, const GridOptions& options);

FieldLookUp solved_field(PreparedField prepared, const GridOptions& options);

}  // namespace pomona
