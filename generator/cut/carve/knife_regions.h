// What of a fruit lies on the surface of a closed knife.
#pragma once

#include <functional>
#include <vector>

#include "generator/cut/carve/split_surfaces.h"
#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"

namespace pomona {

/// How often the parts of bodies wind around one triangle of a surface.
struct KnownWindings {
  std::uint32_t triangle = 0;
  std::vector<CellBoundary> inside;  ///< ascending by cell and body, no zeros
};

/// For a triangle, what is known of some triangle of the same closed surface.
using FirstWindings = std::function<KnownWindings(std::uint32_t)>;

/// The patches of a knife's face (knife_face.h). Every part of a body in a cell is bounded by skins and cut faces that
/// close by identity; so whoever goes over the knife's surface and counts them at the edges they pass through knows
/// what he is in, whatever rounding has done to their places. Inside the knife cells have a number greater by `stride`.
Regions knife_regions(const Face& face, const KnifeTraces& traces, std::uint32_t stride,
                      const DiffusionSurfaces& surfaces, const Bodies& bodies, const FirstWindings& first);

/// Adds what crossing boundaries `times` times, from before to behind, changes.
void cross(std::vector<CellBoundary>& inside, const std::vector<CellBoundary>& boundary, int times);

}  // namespace pomona
