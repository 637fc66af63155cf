// Fruits in storage buffers, as many at a time as fit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/diffusion/ray_surfaces.h"
#include "render/gl/objects.h"

namespace pomona {

/// The start of a fruit in the buffers.
struct FruitPlace {
  std::uint32_t node = 0, triangle = 0, vertex = 0;
};

/// Some fruits, uploaded one behind the other.
struct GlFruits {
  std::vector<FruitPlace> place;
  GlBuffer nodes, triangles, sides, colors;
};

GlFruits uploaded(const CurrentGl& gl, std::span<const RaySurfaces> fruits);

/// Runs of fruits whose buffers hold at most `max_bytes` each: the index at which every run begins, and the end.
/// \throws Error (helper_missing) if one fruit alone needs more.
std::vector<std::size_t> runs_that_fit(std::span<const RaySurfaces> fruits, std::size_t max_bytes);

}  // namespace pomona
