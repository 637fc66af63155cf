// The bodies of a fruit, united where they overlap: the input of a cut.
#pragma once

#include <optional>
#include <utility>

#include "generator/cut/unite/united_bodies.h"
#include "generator/surface/bodies.h"

namespace pomona {

inline DiffusionSurfaces without_overlaps(DiffusionSurfaces surfaces) {
  std::optional<UnitedBodies> united = united_bodies(surfaces, find_bodies(surfaces));
  return united ? std::move(united->surfaces) : std::move(surfaces);
}

}  // namespace pomona
