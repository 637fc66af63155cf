// Browning: cut faces that have lain in air.
#pragma once

#include <span>
#include <vector>

#include "generator/cut/cut.h"
#include "generator/cut/section/cross_section.h"
#include "generator/diffusion/diffuser.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// The section with its diffused colours, browned as `fruit.individual` says: see BrowningSketch. Browning depends on
/// the place in the fruit, so two cuts agree where they meet. Colours only change towards those of the sketch; at
/// browning 0 they keep their bits.
/// \param surfaces the surfaces that were cut.
CrossSection browned(CrossSection section, const DiffusionSurfaces& surfaces, const Template& fruit,
                     Threads threads = {});

/// The same for colours diffused at any points of cut faces, one per point.
DiffusedColors browned(DiffusedColors colors, std::span<const glm::vec3> points, const DiffusionSurfaces& surfaces,
                       const Template& fruit);

/// The same for the freshly exposed walls of spared parts: the socket of a stone, and the stone.
std::vector<CutPiece> browned(std::vector<CutPiece> pieces, const DiffusionSurfaces& surfaces, const Template& fruit);

}  // namespace pomona
