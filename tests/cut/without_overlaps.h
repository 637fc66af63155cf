// The bodies of a fruit, united where they overlap: the input of a cut.
#pragma once

#include <optional>
#include <utility>

#include "generator/cut/unite/united_bodies.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// What a cut no longer unites. Uniting rounds points, so that some of what was united may overlap anew: a pumpkin of
/// 2 000 triangles wants it three times.
inline DiffusionSurfaces without_overlaps(DiffusionSurfaces surfaces) {
  constexpr int most = 8;
  for (int i = 0; i < most; ++i) {
    std::optional<UnitedBodies> united = united_bodies(surfaces, find_bodies(surfaces));
    if (!united) break;
    surfaces = std::move(united->surfaces);
  }
  return surfaces;
}

}  // namespace pomona
