// Spots and patches on a swept surface.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/base/random.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/sweep/spot.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// All spots of one side of a surface, in the order in which they are painted. The positions of scattered spots follow
/// from the options' key, so they differ from variant to variant. \throws Error (bad_data) for more than 20 000 of one
/// kind, or so many large ones that painting them would take long.
std::vector<Spot> placed_spots(const Template& fruit, const SurfaceSketch& sketch, SideOf side,
                               std::span<const SweptGrid> grids, const SweepOptions& options);

/// The colours of a grid's vertices with the spots over them, each a blend of its ground and spot colour.
std::vector<Color> with_spots(const SweptGrid& grid, std::vector<Color> ground, std::span<const Spot> spots);

/// Those of a side's spots that have relief, for the side of the air: normals point to the air, rims are as soft as
/// shading needs, and the strength of the colour is ignored.
std::vector<Spot> raised_spots(std::span<const Spot> spots, SideOf side);

/// One warning for every kind of spots whose smallest width is below the widest cell of their surface: some spots may
/// fall between the vertices and be lost.
std::vector<std::string> spot_warnings(const Template& fruit, const SweepOptions& options = {});

}  // namespace pomona
