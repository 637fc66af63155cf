// The identity buffer: the nearest triangle and its instance in each pixel, and its distance.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "render/strokes/seen_solid.h"

namespace pomona {

/// Drawn on the CPU, so that the lines that depend on it are the same on every machine.
struct IdentityBuffer {
  int width = 0, height = 0;
  std::vector<float> nearness;          ///< 1 / distance, 1 / metres; 0 where there is nothing
  std::vector<std::uint32_t> instance;  ///< index + 1; 0 where there is nothing
  std::vector<std::uint32_t> triangle;  ///< triangle of the instance's solid; undefined where there is nothing

  /// The pixel at a position. Positions outside the picture get the nearest pixel of the border.
  std::size_t pixel_at(const glm::dvec2& place) const;
};

IdentityBuffer identity_buffer(const Scene& scene, const Lens& lens, Threads threads);

}  // namespace pomona
