#include "render/truth/truth_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pomona {

namespace {

constexpr double max = 65535;

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
    const double steps = std::clamp(std::round(static_cast<double>(depth) / step), 1.0, max);
    result.image.values.push_back(depth > 0 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0});
  }
  return result;
}

TruthPicture normals(const TruthLayers& layers) {
  TruthPicture result = picture(layers, "normal", 3);
  for (const glm::vec3& n : layers.normal) {
    const bool nothing = n == glm::vec3(0);
    for (int k = 0; k < 3; ++k) {
      const double value = nothing ? 0 : std::clamp(0.5 * (static_cast<double>(n[k]) + 1), 0.0, 1.0) * max;
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
  // Division by whole numbers gives exact decimal steps.
  for (double divisor = 1e9; divisor >= 1; divisor /= 10) {
    for (const double times : {1.0, 2.0, 5.0}) {
      if (times / divisor * max >= static_cast<double>(deepest)) return times / divisor;
    }
  }
  return static_cast<double>(deepest) / max;
}

bool shows_organs(const TruthLayers& layers) {
  return std::any_of(layers.organ.begin(), layers.organ.end(), [](std::uint16_t number) { return number != 0; });
}

std::vector<TruthPicture> pictures_of(const TruthLayers& layers) {
  std::vector<TruthPicture> all{numbers(layers, "instance", layers.instance),
                                numbers(layers, "fruit", layers.fruit),
                                numbers(layers, "part", layers.part),
                                depths(layers),
                                normals(layers),
                                sections(layers)};
  if (shows_organs(layers)) all.push_back(numbers(layers, "organ", layers.organ));
  return all;
}

std::size_t amodal_pictures(std::size_t instances) { return (instances + masks_in_picture - 1) / masks_in_picture; }

std::vector<std::uint16_t> amodal_rows(std::span<const Mask> amodal, std::size_t number, int width, int top,
                                       int bottom) {
  std::vector<std::uint16_t> rows(static_cast<std::size_t>(width) * (bottom - top + 1));
  const std::size_t first = masks_in_picture * number, end = std::min(first + masks_in_picture, amodal.size());
  for (std::size_t i = first; i < end; ++i) {
    const Mask& mask = amodal[i];
    for (int y = std::max(top, mask.box.top); y <= std::min(bottom, mask.box.bottom); ++y) {
      for (int x = mask.box.left; x <= mask.box.right; ++x) {
        if (!mask.at(x, y)) continue;
        std::uint16_t& value = rows[static_cast<std::size_t>(y - top) * width + x];
        value = static_cast<std::uint16_t>(value | 1u << (i - first));
      }
    }
  }
  return rows;
}

TruthPicture amodal_picture(std::span<const Mask> amodal, std::size_t number, int width, int height) {
  return {"amodal_" + std::to_string(number + 1),
          {width, height, 1, amodal_rows(amodal, number, width, 0, height - 1)}};
}

}  // namespace pomona
