#include "generator/template/example_tile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>

#include "generator/base/luminance.h"

namespace pomona {

namespace {

std::size_t index_of(int side, int x, int y, int z) {
  return (static_cast<std::size_t>(z) * static_cast<std::size_t>(side) + static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(side) +
         static_cast<std::size_t>(x);
}

/// The mean of `step` * `step` * `step` texels from (x, y, z) on.
Color mean_of(const TileLevel& level, int step, int x, int y, int z) {
  glm::dvec3 sum(0);
  for (int c = 0; c < step; ++c)
    for (int b = 0; b < step; ++b)
      for (int a = 0; a < step; ++a) sum += glm::dvec3(level.color[index_of(level.side, x + a, y + b, z + c)]);
  return Color(sum / static_cast<double>(step * step * step));
}

/// Half as fine; an odd side leaves the mean alone.
TileLevel coarser(const TileLevel& level) {
  const int step = level.side % 2 == 0 ? 2 : level.side;
  TileLevel next{.side = level.side / step, .color = {}};
  for (int z = 0; z < next.side; ++z)
    for (int y = 0; y < next.side; ++y)
      for (int x = 0; x < next.side; ++x) next.color.push_back(mean_of(level, step, step * x, step * y, step * z));
  return next;
}

std::array<Color, 256> linear_of_bytes() {
  std::array<Color, 256> linear;
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = from_srgb8(glm::u8vec3(static_cast<std::uint8_t>(i)));
  return linear;
}

}  // namespace

ExampleTile example_tile(const std::string& path, int side, std::vector<glm::u8vec3> texel) {
  const std::array<Color, 256> linear = linear_of_bytes();
  ExampleTile tile;
  tile.path = path;
  tile.texel = std::move(texel);
  TileLevel finest{.side = side, .color = {}};
  tile.lowest = Color(1), tile.highest = Color(0);
  tile.darkest = 1, tile.brightest = 0;
  for (const glm::u8vec3& byte : tile.texel) {
    const Color color(linear[byte.r].r, linear[byte.g].g, linear[byte.b].b);
    finest.color.push_back(color);
    tile.lowest = glm::min(tile.lowest, color), tile.highest = glm::max(tile.highest, color);
    tile.darkest = std::min(tile.darkest, luminance(color));
    tile.brightest = std::max(tile.brightest, luminance(color));
  }
  tile.levels.push_back(std::move(finest));
  while (tile.levels.back().side > 1) tile.levels.push_back(coarser(tile.levels.back()));
  return tile;
}

}  // namespace pomona
