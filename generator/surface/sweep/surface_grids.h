// The grids of a template's surfaces, laid along its axis and raised by their cells.
#pragma once

#include <vector>

#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// The grids of one surface: one around the axis, or one per fold that has a loop.
/// \throws Error (bad_data) naming the surface.
std::vector<SweptGrid> swept_grids(const Template& fruit, const SurfaceSketch& sketch, const SweepOptions& options);

}  // namespace pomona
