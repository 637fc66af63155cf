// Bodies that stick out of a fruit's main body: stems, calyces.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/mesh/triangle_tree.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct OuterBodies {
  static constexpr std::int32_t none = -1;

  std::vector<TriangleTree> body;
  std::vector<std::int32_t> of_triangle;  ///< per triangle of the surfaces: the outer body that it bounds, or none
};

/// The closed bodies that stick out of the skin and are longer than a tenth of it. Seeds and achenes in the skin are
/// smaller.
OuterBodies outer_bodies(const DiffusionSurfaces& surfaces, const TriangleTree& skin);

}  // namespace pomona
