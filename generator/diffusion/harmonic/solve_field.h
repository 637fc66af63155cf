// From surfaces to a field that can be asked: grid, links, levels, solution.
#pragma once

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/field_look_up.h"

namespace pomona {

struct GridOptions {
  double spacing = 0;   ///< metres between nodes
  int cycles = 1;       ///< see MultigridOptions
  glm::dvec3 shift{0};  ///< of the grid, in cells
  double reach = 0;     ///< metres: surfaces this near to a cell count as in it
  Threads threads;
};

FieldLookUp solved_field(const DiffusionSurfaces& surfaces, const GridOptions& options);

}  // namespace pomona
