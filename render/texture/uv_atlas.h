// The UV atlas: all charts of a solid on one texture, apart enough that mip levels keep them apart.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "render/texture/uv_charts.h"

namespace pomona {

/// The largest side of a texture, texels.
constexpr int max_texture_side = 8192;

/// Where each chart lies. The texture is divided into blocks of 2^mip_levels texels, each owned by one chart or by
/// none: a chart owns every block that a bilinear look-up anywhere on it reads at any mip level up to mip_levels.
struct Atlas {
  glm::ivec2 size{0};  ///< texels; multiples of a block
  int mip_levels = 0;
  double texels_per_metre = 0;
  std::vector<glm::dvec2> corner;   ///< per chart: where its (0, 0) lies, texels
  std::vector<std::uint8_t> speck;  ///< per chart: 1 if it has the area of a texel or two and lies all at its corner
  std::vector<std::int32_t> owner;  ///< per block, row by row: the chart, or -1

  int block() const { return 1 << mip_levels; }
  glm::ivec2 blocks() const { return size / block(); }
  glm::dvec2 texel(const std::vector<Chart>& charts, std::size_t chart, std::uint32_t place) const {
    return speck[chart] != 0 ? corner[chart] : corner[chart] + charts[chart].flat[place] * texels_per_metre;
  }
};

/// Charts as they lie on the atlas: those of curved surfaces turned.
struct PackedCharts {
  std::vector<Chart> charts;
  Atlas atlas;
};

/// At the largest scale found at which a square of `side` texels holds them. Mip levels are given up one by one if they
/// would cost more than a third of that scale. \throws Error (usage) if there are more charts than texels.
PackedCharts packed_to_side(const std::vector<Chart>& charts, int side, int mip_levels);

/// At `texel` metres a texel, in the smallest texture that holds it; its sides are powers of two, 64 at least.
/// \throws Error (usage) if one of max_texture_side is not enough.
PackedCharts packed_at_texel(const std::vector<Chart>& charts, double texel, int mip_levels);

/// Share of the texture that triangles cover.
double filled_share(const std::vector<Chart>& charts, const Atlas& atlas);

}  // namespace pomona
