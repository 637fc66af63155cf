// Knives that cut by a closed surface, laid at a fruit: balls, corers, bites, drawn profiles and peelers.
#pragma once

#include "generator/knife/knife.h"
#include "generator/mesh/closed_surface.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The closed surface along which this knife cuts. What lies inside it is, for a peeler, the fruit that is left, and
/// what is taken out for all others. \throws Error (usage) for what cannot be cut: a peel thicker than the fruit, a
/// corer shorter than it needs to be, a surface that would cross itself, and (bad_data) a skin that is open.
ClosedSurface knife_solid(const Knife& knife, const DiffusionSurfaces& surfaces);

}  // namespace pomona
