// Reads PNG files, by libpng.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// What each pixel becomes, whatever the file holds.
enum class PngPixels {
  rgb,      ///< three bytes, without opacity
  rgba,     ///< four bytes
  sixteen,  ///< two bytes a channel, the high one first: only of files with 16-bit grey or RGB
};

/// Sizes beyond which a file is refused before memory for its pixels is allocated.
struct PngLimits {
  int side = 16384;
  double pixels = 1e8;
};

/// Rows of pixels, one after another, without gaps.
struct PngRows {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> bytes;
};

/// \param name for messages.
/// \throws Error (bad_data) for what is not a PNG, or is larger than the limits.
PngRows read_png_rows(std::string_view bytes, const std::string& name, PngPixels as, const PngLimits& limits = {});

}  // namespace pomona
