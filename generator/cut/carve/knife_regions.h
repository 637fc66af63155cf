// The regions of a closed knife's surface: which bodies of the fruit are there.
#pragma once

#include <functional>
#include <vector>

#include "generator/cut/carve/split_surfaces.h"
#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"

namespace pomona {

/// The winding numbers of the parts of bodies around one triangle of a surface.
struct KnownWindings {
  std::uint32_t triangle = 0;
  std::vector<CellBoundary> inside;  ///< sorted by cell and body, without zeros
};

/// For a triangle, the winding numbers at some triangle of the same closed surface.
using FirstWindings = std::function<KnownWindings(std::uint32_t)>;

/// The patches of a knife's face (knife_face.h). Every part of a body in a cell is bounded by skins and cut faces that
/// are closed and share their points. So a walk over the knife's surface that counts the boundaries at each edge always
/// knows the bodies around it, whatever the rounding of positions. \param stride the number of a cell inside the knife
/// is larger by this.
Regions knife_regions(const Face& face, const KnifeTraces& traces, std::uint32_t stride,
                      const DiffusionSurfaces& surfaces, const Bodies& bodies, const FirstWindings& first);

/// Updates the winding numbers for a step from before a boundary to behind it, `times` times.
void cross(std::vector<CellBoundary>& inside, const std::vector<CellBoundary>& boundary, int times);

}  // namespace pomona
