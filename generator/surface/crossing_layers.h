// Layers of a fruit that should lie within each other, and cross.
#pragma once

#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// A warning for each two layers that cross: where one lies outside the other, each lends its colours to what is the
/// other's. Layers are surfaces around the axis, within the flesh, from one end to the other. What goes through one on
/// purpose is no layer: a stalk, which is a body of its own; a closed vein beside the axis; a strand, which is less
/// than a seventh as wide.
/// \param swept the template, or a variant, swept.
std::vector<std::string> crossing_layer_warnings(const Template& fruit, const DiffusionSurfaces& swept);

}  // namespace pomona
