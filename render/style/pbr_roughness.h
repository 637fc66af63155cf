// Roughness and films of juice as engines have them: of physically based shading.
#pragma once

#include "generator/template/material_sketch.h"

namespace pomona {

/// Of parts of which nothing is said: dull like flesh.
constexpr double pbr_dull = 0.6;

/// Of a part's skin or cut face, 0..1. A template's 0.3 is 0.6; the wetter a face, the smoother.
double pbr_roughness(const MaterialSketch& material, bool on_cut_face);

/// How much of a clear coat a part's cut face has, 0..0.8: a film of juice is smooth whatever lies under it.
double pbr_film(const MaterialSketch& material);

}  // namespace pomona
