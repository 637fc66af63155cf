// Bodies that a corer pushes aside: a calyx goes with the core it sits on, or stays on the fruit, whole.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/mesh/closed_surface.h"
#include "generator/surface/bodies.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// What a knife does not see, and what it does.
struct HeldBack {
  CutFruit fruit;                         ///< without them
  std::vector<SurfaceTriangle> triangle;  ///< theirs, in the cells they go to
};

/// Takes the bodies that stick out of the fruit out of a knife's way, but those that others have cut. Each goes inside
/// the knife or stays outside of it, as most of it does that is sunk in the fruit: what it sits on.
/// \param stride what lies inside is in the cell with a number that is greater by this.
HeldBack held_back(CutFruit fruit, const ClosedSurface& knife, std::uint32_t stride, const DiffusionSurfaces& surfaces,
                   const Bodies& bodies);

}  // namespace pomona
