// Bodies that overlap become one: what is solid twice counts once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "generator/base/parallel.h"
#include "generator/surface/bodies.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Surfaces whose closed bodies do not overlap.
struct UnitedBodies {
  DiffusionSurfaces surfaces;
  Bodies bodies;  ///< overlapping ones have the number of the first of them
};

struct UniteOptions {
  /// Bodies that stay bodies of their own: each loses the place that it shares with others, and gets a wall there.
  std::span<const std::int32_t> apart = {};
  Threads threads = {};  ///< the result does not depend on them
};

/// Parts the boundaries of overlapping bodies where they pass through each other. What lies inside another body faces
/// air no more: it becomes an inner surface with the same colours and parts, so that a section still shows a stalk in
/// the flesh. Nothing if no bodies overlap: those that only touch stay apart, and so do open ones. Where a body crosses
/// itself just where it crosses another, the two stay as they are.
std::optional<UnitedBodies> united_bodies(const DiffusionSurfaces& surfaces, const Bodies& bodies,
                                          const UniteOptions& options = {});

}  // namespace pomona
