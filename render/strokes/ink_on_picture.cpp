#include "render/strokes/ink_on_picture.h"

#include <array>
#include <map>
#include <vector>

#include "generator/base/color.h"

namespace pomona {

namespace {

void lay_over(Image& picture, const InkLayer& layer, const Color& ink) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto cover = static_cast<float>(layer.at(x, y));
      if (cover == 0) continue;
      glm::u8vec3& pixel = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
      const Color under = from_srgb8(pixel);
      pixel = to_srgb8(under + (ink - under) * cover);
    }
  }
}

}  // namespace

Image with_ink(Image picture, std::span<const SceneStroke> strokes) {
  // What overlaps in one ink is no darker; the finer lines lie under the outlines.
  for (const bool finer : {true, false}) {
    std::map<std::array<float, 3>, std::vector<const SceneStroke*>> by_ink;
    for (const SceneStroke& stroke : strokes) {
      const Color& ink = stroke.color;
      if (is_inner(stroke.kind) == finer) by_ink[{ink.r, ink.g, ink.b}].push_back(&stroke);
    }
    for (const auto& [ink, of_it] : by_ink) {
      InkLayer layer(picture.width, picture.height);
      for (const SceneStroke* stroke : of_it) layer.draw(stroke->points);
      lay_over(picture, layer, Color(ink[0], ink[1], ink[2]));
    }
  }
  return picture;
}

}  // namespace pomona
