// Sheets as closed shells: leaves that lie on each other, plates side by side, what is rolled or stacked.
#pragma once

#include <functional>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/sweep/sweep_options.h"
#include "generator/surface/sweep/swept_grid.h"
#include "generator/template/template.h"

namespace pomona {

/// A sheet's two faces, as many vertices each, and the rim between them: `around` runs across, 0 to 1, `turn` is its
/// age.
SweptGrid sheet_shell(const std::vector<glm::dvec3>& lower, const std::vector<glm::dvec3>& upper, int around, int along,
                      double age);

/// How old a sheet is: 0 the first, 1 the last.
double age_of(const SheetSketch& sketch, int sheet);

/// Makes one sheet of a kind, by its number from 0. It refers to the sketch, which must outlive it.
using SheetShell = std::function<SweptGrid(int sheet)>;

/// Leaves of a head or a rosette. Each is the graph of a height over its outline on a disc about the pole, and lies on
/// the smoothed upper envelope of those before it; so none cross.
/// \throws Error (bad_data) where so many leaves have no room between the two curves
SheetShell leaf_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options);

/// Plates in half-planes through the axis.
/// \throws Error (bad_data), here or of a plate, where they are too thick for their number
SheetShell blade_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options);

/// Sheets that wind around the axis from the innermost turn to the outermost, side by side where they are several.
/// Vertices of neighbouring turns lie at the same azimuths, so flat facets keep their order.
/// \throws Error (bad_data) where so many turns have no room between the two curves
SheetShell roll_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options);

/// Layers over each other: each between two heights over the ground that its neighbours share, wherever it ends.
/// \throws Error (bad_data) where so many layers have no room between the two curves
SheetShell stack_shell(const Template& fruit, const SheetSketch& sketch, const SweepOptions& options);

/// Appends all sheets of the fruit, one surface for each sketch.
void append_sheets(DiffusionSurfaces& surfaces, const Template& fruit, const SweepOptions& options);

}  // namespace pomona
