// The texels of a chart, and the points of the solid whose colours they show.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/texture/uv_atlas.h"

namespace pomona {

/// A sample of a texel: a point of the solid. A texel shows the mean of its samples.
struct TexelSample {
  glm::ivec2 texel{0};         ///< texel of the atlas
  std::uint32_t triangle = 0;  ///< triangle of the solid
  glm::dvec3 weight{0};        ///< barycentric, of its corners
  bool outside = false;        ///< the texel's middle lies outside the chart; this is the nearest point on it
};

/// The samples of every texel that a texture lookup on the chart may read: one in its middle; four where a line with a
/// change of colour passes through it; the nearest point where it only touches the chart. A speck has none.
std::vector<TexelSample> texel_samples(const Solid& solid, const std::vector<Chart>& charts, std::size_t chart,
                                       const Atlas& atlas);

}  // namespace pomona
