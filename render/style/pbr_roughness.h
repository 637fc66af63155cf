// Roughness and films of juice for engines with physically based shading.
#pragma once

#include "generator/template/material_sketch.h"

namespace pomona {

/// The roughness of parts without a material: dull like flesh.
constexpr double pbr_dull = 0.6;

/// The roughness of a part's skin or cut face, 0..1. A template's 0.3 becomes 0.6; wetter faces are smoother.
double pbr_roughness(const MaterialSketch& material, bool on_cut_face);

/// The clear coat of a part's cut face, 0..0.8: a film of juice is smooth on any part.
double pbr_film(const MaterialSketch& material);

}  // namespace pomona
