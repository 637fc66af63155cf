// The UV atlas: all charts of a solid on one texture, apart enough that mip levels keep them apart.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "render/texture/uv_charts.h"

namespace pomona {

/// The largest side of a texture, texels.
constexpr int max_texture_side = 8192;

/// The position of each chart. The texture is divided into blocks of 2^mip_levels texels. Each block is owned by one
/// chart or by none: a chart owns every block that a bilinear sample anywhere on it reads, at any mip level up to
/// mip_levels.
struct Atlas {
  glm::ivec2 size{0};  ///< texels; multiples of a block
  int mip_levels = 0;
  double texels_per_metre = 0;
  std::vector<glm::dvec2> corner;   ///< per chart: position of its (0, 0), texels
  std::vector<std::uint8_t> speck;  ///< per chart: 1 if it is only a texel or two large; it then lies at its corner
  std::vector<std::int32_t> owner;  ///< per block, row by row: the chart, or -1

  int block() const { return 1 << mip_levels; }
  glm::ivec2 blocks() const { return size / block(); }
  glm::dvec2 texel(const std::vector<Chart>& charts, std::size_t chart, std::uint32_t place) const {
    return speck[chart] != 0 ? corner[chart] : corner[chart] + charts[chart].flat[place] * texels_per_metre;
  }
};

/// Charts as they lie on the atlas; those of curved surfaces are rotated.
struct PackedCharts {
  std::vector<Chart> charts;
  Atlas atlas;
};

/// Packs the charts into a square of `side` texels, at the largest scale that was found. The number of mip levels is
/// reduced if these would cost more than a third of the scale. \throws Error (usage) if there are more charts than
/// texels.
PackedCharts packed_to_side(const std::vector<Chart>& charts, int side, int mip_levels);

/// Packs the charts with texels of `texel` metres into the smallest texture; its sides are powers of two, at least 64.
/// \throws Error (usage) if one of max_texture_side is not enough.
PackedCharts packed_at_texel(const std::vector<Chart>& charts, double texel, int mip_levels);

/// Share of the texture that triangles cover.
double filled_share(const std::vector<Chart>& charts, const Atlas& atlas);

}  // namespace pomona
