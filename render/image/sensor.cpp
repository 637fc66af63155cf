#include "render/image/sensor.h"

#include <algorithm>
#include <cmath>

#include "generator/base/color.h"
#include "generator/base/reproducible.h"
#include "render/image/linear_pixels.h"

namespace pomona {

namespace {

/// The weights of a Gaussian from its middle outwards; both sides together sum to 1.
std::vector<float> gaussian(double deviation) {
  const int reach = static_cast<int>(std::ceil(3 * deviation));
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i <= reach; ++i) {
    weights.push_back(reproducible::exp(-0.5 * i * i / (deviation * deviation)));
    sum += (i > 0 ? 2 : 1) * weights.back();
  }
  std::vector<float> shares;
  for (const double weight : weights) shares.push_back(static_cast<float>(weight / sum));
  return shares;
}

/// One direction of the blur; pixels beyond the edge are as the edge.
std::vector<Color> blurred(const std::vector<Color>& pixels, int width, int height, const std::vector<float>& weights,
                           bool across) {
  std::vector<Color> result(pixels.size());
  const int reach = static_cast<int>(weights.size()) - 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = [&](int by) {
        const int column = across ? std::clamp(x + by, 0, width - 1) : x;
        const int row = across ? y : std::clamp(y + by, 0, height - 1);
        return pixels[static_cast<std::size_t>(row) * width + column];
      };
      Color sum = at(0) * weights[0];
      for (int by = 1; by <= reach; ++by) sum += (at(-by) + at(by)) * weights[static_cast<std::size_t>(by)];
      result[static_cast<std::size_t>(y) * width + x] = sum;
    }
  }
  return result;
}

/// About normal, of variance 1: the sum of four uniforms out of one draw.
float nearly_normal(std::uint64_t bits) {
  constexpr double steps = 65536, deviation = 0.5773502691896258;  // of four uniforms of [0, 1): sqrt(4 / 12)
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += static_cast<double>(bits >> 16 * k & 0xffff) / steps;
  return static_cast<float>((sum - 2) / deviation);
}

void add_noise(std::vector<Color>& pixels, const SensorOptions& options) {
  constexpr float in_the_dark = 0.2f;
  const RandomStream noise(options.key, "sensor/noise");
  const auto strength = static_cast<float>(options.noise);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      float& light = pixels[i][channel];
      const float deviation = strength * std::sqrt(in_the_dark + (1 - in_the_dark) * std::max(0.0f, light));
      light += deviation * nearly_normal(noise.bits(3 * i + static_cast<std::size_t>(channel)));
    }
  }
}

}  // namespace

Image sensed(const Image& picture, const SensorOptions& options) {
  if (options.exposure == 0 && options.blur <= 0 && options.noise <= 0) return picture;
  std::vector<Color> pixels = linear_pixels(picture);
  if (options.blur > 0) {
    const std::vector<float> weights = gaussian(options.blur);
    for (const bool across : {true, false}) pixels = blurred(pixels, picture.width, picture.height, weights, across);
  }
  const auto light = static_cast<float>(reproducible::exp(options.exposure * 0.6931471805599453));
  for (Color& pixel : pixels) pixel *= light;
  if (options.noise > 0) add_noise(pixels, options);
  return image_of(pixels, picture.width, picture.height);
}

}  // namespace pomona
