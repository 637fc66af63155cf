#include "generator/order/order.h"

#include <cmath>

#include "generator/base/error.h"

namespace pomona {

VariantKey key_of(const FruitOrder& fruit) { return {fruit.seed.value_or(0), fruit.index.value_or(0)}; }

GrowOptions growing_of(const Order& order) {
  GrowOptions growing = order.fruit.growing;
  growing.as_drawn = growing.as_drawn || (order.fruit.seed.value_or(0) == 0 && !order.fruit.index);
  growing.threads = order.threads;
  return growing;
}

Order without(Order order, const std::vector<Format>& formats) {
  std::erase_if(order.outputs, [&](const Output& output) { return any_is({output}, formats); });
  return order;
}

bool wants_textures(const MeshOrder& mesh) { return mesh.texture > 0 || mesh.texel.metres > 0; }

std::string drawn_style(const ColorOrder& color) { return color.style.empty() ? "ink" : color.style; }

std::string baked_style(const ColorOrder& color) { return color.style.empty() ? "photo" : color.style; }

AtlasOf atlas_of(const MeshOrder& mesh) {
  const bool draws = mesh.engine == Engine::godot || mesh.engine == Engine::unreal || mesh.engine == Engine::unity;
  return mesh.atlas.value_or(draws ? AtlasOf::piece : AtlasOf::none);
}

std::optional<PictureSize> picture_size(const PictureOrder& picture) {
  if (!picture.size) return std::nullopt;
  const PictureExtent& size = *picture.size;
  const bool on_paper = size.inches_a_unit > 0;
  if (on_paper && picture.dpi == 0)
    throw Error(ExitStatus::usage, "--size " + size.text + " is a size on paper",
                "say how many pixels an inch is to have: --dpi 300");
  const auto pixels = [&](double side) {
    return on_paper ? std::floor(side * size.inches_a_unit * picture.dpi + 0.5) : side;
  };
  const auto fits = [](double side) { return side >= 16 && side <= 16384 && side == std::floor(side); };
  const double width = pixels(size.width), height = pixels(size.height);
  if (!fits(width) || !fits(height))
    throw Error(ExitStatus::usage, "--size " + size.text + " is not a picture size",
                "write 800x600, or 120x90mm with --dpi 300; 16 to 16384 pixels a side");
  return PictureSize{static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace pomona
