// Blur: every blurred surface becomes two sheets moved apart along the normals (paper, Figure 2).
#pragma once

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Splits blurred surfaces into a front sheet at +blur and a back sheet at -blur along the area-weighted
/// vertex normal, each with its colour on both faces. On boundary triangles the boundary stays and only the
/// visible side's sheet moves inwards; at open rims, and where a surface turns from boundary to inner, blur
/// is 0. Below 1e-6 of the fruit's size one two-sided surface remains. In the result all blur is 0; sheets keep
/// the name of their surface, and each bears its side's part on both faces. Making sheets again changes nothing.
DiffusionSurfaces sheets(const DiffusionSurfaces& surfaces);

}  // namespace pomona
