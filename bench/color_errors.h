// The errors of colours.
#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include "generator/base/color.h"

namespace pomona::bench {

/// In parts of 255. `rms` is over all channels of all points; the others are over points, each by its worst channel.
struct ColorErrors {
  double rms = 0, mean = 0, p95 = 0, max = 0;
};

enum class Encoding { linear, srgb };

/// \param colors, truth one entry per point.
ColorErrors color_errors(std::span<const Color> colors, std::span<const Color> truth,
                         Encoding encoding = Encoding::linear);

nlohmann::ordered_json json_of(const ColorErrors& errors);

}  // namespace pomona::bench
