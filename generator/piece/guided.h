// Guides for texture detail: where the surfaces run at each place of a cut face or skin (paper, section 6).
#pragma once

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/template/template.h"

namespace pomona {

/// Gives every vertex of a coloured section its guide, if the template has details for cut faces; else the section as
/// it came. The way across the layers is the diffused normal of the surfaces around the axis, as long as the place is
/// deep; the layer is the diffused mean depth of those surfaces. Both are 0 where no detail counts, nor near by.
/// Elsewhere a guide depends on its place alone, so two cuts agree.
/// \param swept all surfaces before blur is split.
/// \param known their skin, if somebody has it; the result is the same.
CrossSection guided(CrossSection section, const DiffusionSurfaces& swept, const Template& fruit, Threads threads = {},
                    const SkinDepth* known = nullptr);

/// How much each detail of that kind of face counts for a part at a depth below the skin, metres.
glm::vec4 detail_shares(const Template& fruit, DetailFace face, std::int32_t part, double depth);

}  // namespace pomona
