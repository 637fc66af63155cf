// The parts that a fruit's sides use, numbered without gaps, because weights are stored per point and part.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct UsedParts {
  std::vector<std::int32_t> part;  ///< ascending; index into part_names

  // One entry per triangle: index into `part`.
  std::vector<std::uint16_t> front, back;
};

/// \throws Error (bad_data) if more than 1024 parts are used.
UsedParts used_parts(const DiffusionSurfaces& surfaces);

}  // namespace pomona
