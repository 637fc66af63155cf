// The simplest computation of positive mean values, to compare the fast ones with. It can make known mistakes, to check
// that tests notice them.
#pragma once

#include "generator/diffusion/pmvc_value.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

enum class Mistake {
  none,
  uniform_solid_angle,  ///< every texel of the cube counts the same
  planar_distance,      ///< uses the depth along the face's axis in place of the distance
  both,
};

/// Tests every ray of a cube of 6 x texels^2 directions against every triangle.
PmvcValue brute_force_pmvc(const DiffusionSurfaces& surfaces, const glm::dvec3& point, int texels,
                           Mistake mistake = Mistake::none);

}  // namespace pomona
