// Bodies that a corer does not cut but pushes aside: a calyx goes whole with the core that it sits on, or stays whole
// on the fruit.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/mesh/closed_surface.h"
#include "generator/surface/bodies.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A fruit without the bodies that the knife does not cut, and these bodies.
struct HeldBack {
  CutFruit fruit;                         ///< without these bodies
  std::vector<SurfaceTriangle> triangle;  ///< of these bodies, in the cells to which they go
};

/// Takes out the bodies that stick out of the fruit, except those that other knives have cut. A body goes to the inside
/// or the outside of the knife, wherever the larger share of its part inside the fruit lies. \param stride the number
/// of a cell inside the knife is larger by this.
HeldBack held_back(CutFruit fruit, const ClosedSurface& knife, std::uint32_t stride, const DiffusionSurfaces& surfaces,
                   const Bodies& bodies);

}  // namespace pomona
