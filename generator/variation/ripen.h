// Ripening: from the drawn colours of surfaces to those of an individual.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/template/template.h"

namespace pomona {

/// The ripeness, 0..2, of a point on a fruit of this ripeness: see RipenessSketch. `lateness` is clamped to 0..1.
double own_ripeness(double ripeness, double lateness, double spread);

/// The mean drawn colours of the parts of tissues, OKLab, by part: on swept surfaces, or on grains where these have
/// none. Others are black.
std::vector<glm::dvec3> tissue_colors(const DiffusionSurfaces& swept, const DiffusionSurfaces& grains,
                                      const Template& fruit);

/// The swept surfaces in the colours of `fruit.individual`. The colour of each side ripens by its part, its depth below
/// the skin and its height; then the colour shift of its part is added. Channels stay within 0..1. Colours that do not
/// change keep their bits; for an individual as drawn, these are all colours. All parts of a tissue move in sRGB by as
/// much as the mean colour of its leading part does, so that they stay as unlike as drawn; one that follows ripens by
/// itself only if the template says how. Farther from 1 than variants stray, each ripens by itself. \param skin of the
/// whole fruit. \param leads tissue_colors() of the whole fruit.
DiffusionSurfaces ripened(DiffusionSurfaces surfaces, const Template& fruit, const SkinDepth& skin,
                          const std::vector<glm::dvec3>& leads, Threads threads = {});

/// True if `ripened` changes anything.
bool has_own_colors(const Template& fruit);

}  // namespace pomona
