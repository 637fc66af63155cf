// Walls end where they meet a grain: what lies within a seed is the seed's alone.
#pragma once

#include <span>

#include "generator/base/parallel.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// `walls` without what of their inner surfaces lies within `grains`. A seed that stands on a wall would else be
/// divided by it, and diffusion would colour the seed's inside as the wall. What faces air stays, so bodies stay
/// closed. Walls end a fortieth of a grain below its surface, so that lines of a section still meet there.
/// \param grains as scatter_grains() makes them: each is closed, and shares no vertex with another.
/// \param spared parts whose walls stay whole, because knives go around them.
DiffusionSurfaces without_walls_in_grains(DiffusionSurfaces walls, const DiffusionSurfaces& grains,
                                          std::span<const int> spared = {}, Threads threads = {});

}  // namespace pomona
