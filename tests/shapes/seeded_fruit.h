// A fruit for measurements: about 20 000 triangles of all kinds that templates make.
#pragma once

#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona::shapes {

/// A bumpy skin, an inner wall, five chambers with thirty seeds each, and five open septa; radius about 4 cm
/// around the origin, 21 344 triangles. Colours vary over the surfaces and from vertex to vertex, and differ
/// between sides.
DiffusionSurfaces seeded_fruit();

/// About `count` points inside it on a tilted plane through the chambers: a jittered grid, none within 1.5 % of
/// the skin.
std::vector<glm::vec3> points_on_section_of_seeded_fruit(int count);

}  // namespace pomona::shapes
