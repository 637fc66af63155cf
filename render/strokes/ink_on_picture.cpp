#include "render/strokes/ink_on_picture.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "generator/base/color.h"
#include "generator/base/parallel.h"

namespace pomona {

namespace {

constexpr int rows_of_a_band = 64;

void lay_over(Image& picture, PictureRows rows, const InkLayer& layer, const Color& ink) {
  for (int y = rows.from; y < rows.to; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto cover = static_cast<float>(layer.at(x, y));
      if (cover == 0) continue;
      glm::u8vec3& pixel = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
      const Color under = from_srgb8(pixel);
      pixel = to_srgb8(under + (ink - under) * cover);
    }
  }
}

using StrokesByInk = std::map<std::array<float, 3>, std::vector<const SceneStroke*>>;

StrokesByInk strokes_by_ink(std::span<const SceneStroke> strokes, bool finer) {
  StrokesByInk by_ink;
  for (const SceneStroke& stroke : strokes) {
    const Color& ink = stroke.color;
    if (is_inner(stroke.kind) == finer) by_ink[{ink.r, ink.g, ink.b}].push_back(&stroke);
  }
  return by_ink;
}

}  // namespace

Image with_ink(Image picture, std::span<const SceneStroke> strokes, Threads threads) {
  // Overlaps of one ink are not darker; finer lines lie under outlines.
  const std::array<StrokesByInk, 2> layers{strokes_by_ink(strokes, true), strokes_by_ink(strokes, false)};
  const auto bands = static_cast<std::size_t>((picture.height + rows_of_a_band - 1) / rows_of_a_band);
  parallel_for(bands, threads, [&](std::size_t band) {
    const int from = static_cast<int>(band) * rows_of_a_band;
    const PictureRows rows{from, std::min(from + rows_of_a_band, picture.height)};
    for (const StrokesByInk& by_ink : layers) {
      for (const auto& [ink, of_it] : by_ink) {
        InkLayer layer(picture.width, rows);
        for (const SceneStroke* stroke : of_it) layer.draw(stroke->points);
        lay_over(picture, rows, layer, Color(ink[0], ink[1], ink[2]));
      }
    }
  });
  return picture;
}

}  // namespace pomona
