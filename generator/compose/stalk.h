// Stalks: tapered tubes from the axis to instances.
#pragma once

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// A closed tube from `root` to `top`, which sags a little on its way.
DiffusionSurfaces stalk_between(const StalkSketch& stalk, const std::string& part, const glm::dvec3& root,
                                const glm::dvec3& top);

}  // namespace pomona
