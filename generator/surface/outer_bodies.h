// Bodies that stick out of a fruit's main one: stems, calyces.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/mesh/triangle_tree.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct OuterBodies {
  static constexpr std::int32_t none = -1;

  std::vector<TriangleTree> body;
  std::vector<std::int32_t> of_triangle;  ///< per triangle of the surfaces: which body it bounds, or none
};

/// Closed ones that stick out of the skin and are longer than a tenth of it. Seeds and achenes in the skin are smaller.
OuterBodies outer_bodies(const DiffusionSurfaces& surfaces, const TriangleTree& skin);

}  // namespace pomona
