#include "render/picture/marks_on_picture.h"

namespace pomona {

std::vector<StrokePoint> stroke_of(const Mark& mark) {
  std::vector<StrokePoint> stroke;
  for (const MarkPoint& point : mark) stroke.push_back({point.at, point.radius, 1});
  if (stroke.size() == 1) stroke.push_back(StrokePoint(stroke.front()));
  return stroke;
}

Image with_marks(const Image& painted, const Paper& paper, std::span<const Mark> marks, const MarkStyle& style,
                 const Color& ink) {
  InkLayer layer(painted.width, painted.height);
  for (const Mark& mark : marks) layer.draw(stroke_of(mark));

  Image image = painted;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      glm::u8vec3& pixel = image.pixels[static_cast<std::size_t>(y) * image.width + x];
      Color color = blended(paper.at(x, y), from_srgb8(pixel), style.wash);
      color += (ink - color) * static_cast<float>(layer.at(x, y));
      pixel = to_srgb8(color);
    }
  }
  return image;
}

}  // namespace pomona
