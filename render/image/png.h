// PNG files, by libpng.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/image/image.h"

namespace pomona {

/// How a PNG is packed.
enum class PngPacking {
  small,  ///< for pictures
  fast,   ///< for thousands of textures: a quarter of the time, 3 to 8 % more bytes (docs/reports/textures.md)
};

/// The kind of a picture's numbers.
enum class PngValues {
  srgb,    ///< colours, marked as sRGB
  shares,  ///< shares of 255, as in normal maps, without a colour space
};

/// The file's bytes: 8-bit RGB marked as sRGB, no time, the same for the same picture (filter and compression
/// level are fixed). Says how many pixels an inch has where the picture does.
std::string write_png(const Image& image, PngPacking packing = PngPacking::small, PngValues values = PngValues::srgb);

/// The same with opacity: 8-bit RGBA.
std::string write_png(const TransparentImage& image, PngPacking packing = PngPacking::small,
                      PngValues values = PngValues::srgb);

/// \param name for messages.
/// \throws Error (bad_data) for what is not a PNG, or is larger than max_picture_side either way.
Image read_png(const std::string& bytes, const std::string& name);

/// Like read_png(), with opacity.
TransparentImage read_transparent_png(const std::string& bytes, const std::string& name);

}  // namespace pomona
