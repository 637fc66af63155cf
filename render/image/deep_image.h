// Pictures of numbers: 16 bits a channel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pomona {

/// One channel, or three; row by row from the top left.
struct DeepImage {
  int width = 0, height = 0, channels = 1;
  std::vector<std::uint16_t> values;

  std::uint16_t at(int x, int y, int channel = 0) const {
    return values[(static_cast<std::size_t>(y) * width + x) * channels + channel];
  }
};

/// The bytes of a PNG, 16-bit grey or RGB: numbers, not colours, so without gamma. Same picture, same bytes.
std::string write_png(const DeepImage& image);

/// \param name for messages.
/// \throws Error (bad_data) for what is not a PNG of 16-bit grey or RGB, or is larger than max_picture_side either way.
DeepImage read_deep_png(const std::string& bytes, const std::string& name);

}  // namespace pomona
