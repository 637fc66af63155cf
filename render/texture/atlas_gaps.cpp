#include "render/texture/atlas_gaps.h"

#include <algorithm>
#include <vector>

#include "generator/base/color.h"

namespace pomona {

namespace {

/// Linear colours of squares of texels, and whether they are known.
struct Level {
  glm::ivec2 size{0};
  std::vector<Color> sum;
  std::vector<float> weight;

  explicit Level(const glm::ivec2& of)
      : size(of), sum(static_cast<std::size_t>(of.x) * of.y, Color(0)), weight(sum.size(), 0) {}
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * size.x + x; }
};

Level half_of(const Level& fine) {
  Level half((fine.size + 1) / 2);
  for (int y = 0; y < fine.size.y; ++y) {
    for (int x = 0; x < fine.size.x; ++x) {
      half.sum[half.at(x / 2, y / 2)] += fine.sum[fine.at(x, y)];
      half.weight[half.at(x / 2, y / 2)] += fine.weight[fine.at(x, y)];
    }
  }
  return half;
}

/// One entry per block of the atlas: the mean of its texels.
Level blocks_of(const Atlas& atlas, const Image& image) {
  Level level(atlas.blocks());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t block = level.at(x / atlas.block(), y / atlas.block());
      if (atlas.owner[block] < 0) continue;
      level.sum[block] += from_srgb8(image.at(x, y));
      level.weight[block] += 1;
    }
  }
  return level;
}

}  // namespace

void fill_gaps(Image& image, const Atlas& atlas) {
  std::vector<Level> levels{blocks_of(atlas, image)};
  while (std::max(levels.back().size.x, levels.back().size.y) > 1) levels.push_back(half_of(levels.back()));
  for (int y = 0; y < levels[0].size.y; ++y) {
    for (int x = 0; x < levels[0].size.x; ++x) {
      if (atlas.owner[levels[0].at(x, y)] >= 0) continue;
      glm::u8vec3 pixel(0);
      for (std::size_t l = 1; l < levels.size(); ++l) {
        const std::size_t i = levels[l].at(x >> l, y >> l);
        if (levels[l].weight[i] == 0) continue;
        pixel = to_srgb8(levels[l].sum[i] / levels[l].weight[i]);
        break;
      }
      for (int v = 0; v < atlas.block(); ++v) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y * atlas.block() + v) * image.width;
        std::fill_n(row + static_cast<std::ptrdiff_t>(x) * atlas.block(), atlas.block(), pixel);
      }
    }
  }
}

}  // namespace pomona
