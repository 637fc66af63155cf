// Guides for texture detail: the direction and depth of the layers at each point of a cut face or skin (paper, section
// 6).
#pragma once

#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/skin_depth.h"
#include "generator/template/template.h"

namespace pomona {

/// Gives every vertex of a coloured section its guide, and the section its lattice, if the template has details for cut
/// faces; else returns the section unchanged. The direction across the layers is the diffused normal of the surfaces
/// around the axis; its length is the depth of the point. The layer is the diffused mean depth of those surfaces. Both
/// are found at the nodes of a lattice that no cut moves, and between them by the lattice: they depend on the place
/// alone, so two cuts agree to the bit. They are 0 where no detail has an effect on the point or near it. \param swept
/// all surfaces before sheets(). \param known their skin, if it exists already; the result is the same.
CrossSection guided(CrossSection section, const DiffusionSurfaces& swept, const Template& fruit, Threads threads = {},
                    const SkinDepth* known = nullptr);

/// The way to the skin and the layer at each of the points, metres, whatever its part; no shares. Each depends on its
/// point alone. Points beyond the skin have ways that lead outwards, too.
std::vector<DetailGuide> layer_guides(const std::vector<glm::vec3>& points, const DiffusionSurfaces& swept,
                                      const Template& fruit, const SkinDepth& skin, Threads threads = {});

/// Whether the details of cut faces ask for ways at all.
bool has_directed_details(const Template& fruit);

/// The strength of each detail of this kind of face for a part at a depth below the skin, metres.
glm::vec4 detail_shares(const Template& fruit, DetailFace face, std::int32_t part, double depth);

}  // namespace pomona
