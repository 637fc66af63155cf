#include "bench/color_errors.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace pomona::bench {

namespace {

glm::dvec3 encoded(const Color& color, Encoding encoding) {
  if (encoding == Encoding::linear) return glm::dvec3(color);
  return {srgb_from_linear(static_cast<double>(color.x)), srgb_from_linear(static_cast<double>(color.y)),
          srgb_from_linear(static_cast<double>(color.z))};
}

}  // namespace

ColorErrors color_errors(std::span<const Color> colors, std::span<const Color> truth, Encoding encoding) {
  ColorErrors errors;
  std::vector<double> worst;
  double squares = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const glm::dvec3 error = 255.0 * (encoded(colors[i], encoding) - encoded(truth[i], encoding));
    squares += glm::dot(error, error);
    worst.push_back(std::max({std::fabs(error.x), std::fabs(error.y), std::fabs(error.z)}));
    errors.mean += worst.back();
  }
  if (worst.empty()) return errors;

  std::sort(worst.begin(), worst.end());
  const auto count = static_cast<double>(worst.size());
  errors.rms = std::sqrt(squares / (3 * count));
  errors.mean /= count;
  errors.p95 = worst[worst.size() * 95 / 100];
  errors.max = worst.back();
  return errors;
}

nlohmann::ordered_json json_of(const ColorErrors& errors) {
  return {{"rms", errors.rms}, {"mean", errors.mean}, {"p95", errors.p95}, {"max", errors.max}};
}

}  // namespace pomona::bench
