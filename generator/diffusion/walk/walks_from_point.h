// All the walks from one point: as many as its standard error asks for.
#pragma once

#include <cstdint>

#include "generator/diffusion/resolved_colors.h"
#include "generator/diffusion/surface_tree.h"
#include "generator/diffusion/used_parts.h"
#include "generator/diffusion/walk/empty_balls.h"
#include "generator/diffusion/walk/walk_options.h"

namespace pomona {

/// Surfaces with all that is known of them before the first walk.
struct WalkGround {
  WalkGround(const DiffusionSurfaces& surfaces, Threads threads);

  const DiffusionSurfaces& surfaces;
  SurfaceTree tree;
  EmptyBalls balls;
  ColorHull hull;
  UsedParts parts;
};

/// One point's entries of a WalkResult.
struct WalkedColor {
  Color color{0};
  std::int32_t part = 0;
  double standard_error = 0;  ///< in 1/255
  std::uint32_t walks = 0, misses = 0;
};

/// \param point metres, finite
WalkedColor walks_from_point(const WalkGround& ground, const glm::vec3& point, const WalkOptions& options);

}  // namespace pomona
