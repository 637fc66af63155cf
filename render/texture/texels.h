// The texels of a chart, and the places on the solid whose colours they show.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/texture/uv_atlas.h"

namespace pomona {

/// A place on the solid, seen by a texel. Texels show the mean of their samples.
struct TexelSample {
  glm::ivec2 texel{0};         ///< of the atlas
  std::uint32_t triangle = 0;  ///< of the solid
  glm::dvec3 weight{0};        ///< barycentric, of its corners
  bool outside = false;        ///< the texel's middle lies beside the chart: this is the nearest place on it
};

/// Every texel that a look-up on the chart may read: one sample in its middle; where a line passes through it across
/// which colours jump, four; where it only touches the chart, the nearest place. A speck has none.
std::vector<TexelSample> texel_samples(const Solid& solid, const std::vector<Chart>& charts, std::size_t chart,
                                       const Atlas& atlas);

}  // namespace pomona
