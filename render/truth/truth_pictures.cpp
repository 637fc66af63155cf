#include "render/truth/truth_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pomona {

namespace {

constexpr double most = 65535;

TruthPicture picture(const TruthLayers& layers, std::string name, int channels) {
  TruthPicture result{std::move(name), {layers.width, layers.height, channels, {}}};
  result.image.values.reserve(layers.instance.size() * static_cast<std::size_t>(channels));
  return result;
}

TruthPicture numbers(const TruthLayers& layers, std::string name, const std::vector<std::uint16_t>& values) {
  TruthPicture result = picture(layers, std::move(name), 1);
  result.image.values = values;
  return result;
}

TruthPicture depths(const TruthLayers& layers) {
  TruthPicture result = picture(layers, "depth", 1);
  const double step = depth_step(layers);
  for (const float depth : layers.depth) {
    const double steps = std::clamp(std::round(static_cast<double>(depth) / step), 1.0, most);
    result.image.values.push_back(depth > 0 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0});
  }
  return result;
}

TruthPicture normals(const TruthLayers& layers) {
  TruthPicture result = picture(layers, "normal", 3);
  for (const glm::vec3& n : layers.normal) {
    const bool nothing = n == glm::vec3(0);
    for (int k = 0; k < 3; ++k) {
      const double value = nothing ? 0 : std::clamp(0.5 * (static_cast<double>(n[k]) + 1), 0.0, 1.0) * most;
      result.image.values.push_back(static_cast<std::uint16_t>(std::lround(value)));
    }
  }
  return result;
}

TruthPicture sections(const TruthLayers& layers) {
  TruthPicture result = picture(layers, "section", 1);
  for (const std::uint8_t cut : layers.section)
    result.image.values.push_back(cut != 0 ? std::uint16_t{65535} : std::uint16_t{0});
  return result;
}

}  // namespace

double depth_step(const TruthLayers& layers) {
  float deepest = 0;
  for (const float depth : layers.depth) deepest = std::max(deepest, depth);
  if (!(deepest > 0)) return 1;
  // Divided by whole numbers, steps are the decimal ones to the bit.
  for (double divisor = 1e9; divisor >= 1; divisor /= 10) {
    for (const double times : {1.0, 2.0, 5.0}) {
      if (times / divisor * most >= static_cast<double>(deepest)) return times / divisor;
    }
  }
  return static_cast<double>(deepest) / most;
}

std::vector<TruthPicture> pictures_of(const TruthLayers& layers) {
  return {numbers(layers, "instance", layers.instance),
          numbers(layers, "fruit", layers.fruit),
          numbers(layers, "part", layers.part),
          depths(layers),
          normals(layers),
          sections(layers)};
}

std::vector<TruthPicture> pictures_of(const std::vector<Mask>& amodal, int width, int height) {
  std::vector<TruthPicture> pictures;
  for (std::size_t i = 0; i < amodal.size(); ++i) {
    if (i % 16 == 0) {
      pictures.push_back({"amodal_" + std::to_string(i / 16 + 1), {width, height, 1, {}}});
      pictures.back().image.values.assign(static_cast<std::size_t>(width) * height, 0);
    }
    const Mask& mask = amodal[i];
    for (int y = mask.box.top; y <= mask.box.bottom; ++y) {
      for (int x = mask.box.left; x <= mask.box.right; ++x) {
        if (!mask.at(x, y)) continue;
        std::uint16_t& value = pictures.back().image.values[static_cast<std::size_t>(y) * width + x];
        value = static_cast<std::uint16_t>(value | 1u << i % 16);
      }
    }
  }
  return pictures;
}

}  // namespace pomona
