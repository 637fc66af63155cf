#include "render/image/png.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <png.h>
#include <glm/vec4.hpp>

#include "generator/base/error.h"
#include "generator/base/png_rows.h"
#include "render/image/deep_image.h"

namespace pomona {

namespace {

/// libpng's own way out of errors is longjmp; an exception thrown from its callback unwinds this side only, so the
/// structures are owned by a destructor here.
[[noreturn]] void fail(png_structp, png_const_charp message) {
  throw Error(ExitStatus::io_error,
              {{{"picture", 0, 0, {}}, std::string("cannot be packed as a PNG: ") + message, ""}});
}

void ignore(png_structp, png_const_charp) {}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png_create_info_struct(png);
  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

// zlib's strategies: Z_DEFAULT_STRATEGY and Z_RLE.
constexpr int any_matches = 0, run_lengths = 3;

void set_size(const Writer& writer, int width, int height, int bits, int color_type) {
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
}

/// Rows of `channels` bytes a pixel, one after another: 3 for RGB, 4 with opacity.
/// \param dpi pixels per inch; 0 = unsaid.
std::string write_rows(const std::uint8_t* rows, int width, int height, int channels, PngPacking packing,
                       PngValues values, double dpi = 0) {
  std::string bytes;
  Writer writer;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  set_size(writer, width, height, 8, channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB);
  if (values == PngValues::srgb) png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);

  // PNG tells pixels per metre, as whole numbers.
  if (dpi > 0) {
    const auto per_metre = static_cast<png_uint_32>(std::floor(dpi / 0.0254 + 0.5));
    png_set_pHYs(writer.png, writer.info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }

  // Fixed, so that the bytes do not depend on libpng's defaults; 6 is within 2 % of 9 at a fifth of the time. Runs of
  // equal bytes alone are found faster still.
  png_set_compression_level(writer.png, 6);
  png_set_compression_strategy(writer.png, packing == PngPacking::fast ? run_lengths : any_matches);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);

  png_write_info(writer.png, writer.info);
  const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  for (int y = 0; y < height; ++y) png_write_row(writer.png, rows + static_cast<std::size_t>(y) * row);
  png_write_end(writer.png, nullptr);
  return bytes;
}

}  // namespace

std::string write_png(const DeepImage& image) {
  // PNG has the high byte first.
  std::vector<std::uint8_t> rows;
  rows.reserve(2 * image.values.size());
  for (const std::uint16_t value : image.values) {
    rows.push_back(static_cast<std::uint8_t>(value >> 8));
    rows.push_back(static_cast<std::uint8_t>(value & 255));
  }
  std::string bytes;
  Writer writer;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  set_size(writer, image.width, image.height, 16, image.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY);
  png_set_compression_level(writer.png, 6);
  png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_write_info(writer.png, writer.info);
  const std::size_t row = 2 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  for (int y = 0; y < image.height; ++y) png_write_row(writer.png, rows.data() + static_cast<std::size_t>(y) * row);
  png_write_end(writer.png, nullptr);
  return bytes;
}

std::string write_png(const Image& image, PngPacking packing, PngValues values) {
  return write_rows(reinterpret_cast<const std::uint8_t*>(image.pixels.data()), image.width, image.height, 3, packing,
                    values, image.dpi);
}

std::string write_png(const TransparentImage& image, PngPacking packing, PngValues values) {
  std::vector<glm::u8vec4> pixels;
  pixels.reserve(image.opacity.size());
  for (std::size_t i = 0; i < image.opacity.size(); ++i) pixels.emplace_back(image.image.pixels[i], image.opacity[i]);
  return write_rows(reinterpret_cast<const std::uint8_t*>(pixels.data()), image.image.width, image.image.height, 4,
                    packing, values);
}

namespace {

Image image_of(const PngRows& rows) { return {.width = rows.width, .height = rows.height, .pixels = {}}; }

}  // namespace

Image read_png(const std::string& bytes, const std::string& name) {
  const PngRows rows = read_png_rows(bytes, name, PngPixels::rgb, {.side = max_picture_side});
  Image image = image_of(rows);
  image.pixels.resize(rows.bytes.size() / 3);
  std::memcpy(image.pixels.data(), rows.bytes.data(), rows.bytes.size());
  return image;
}

TransparentImage read_transparent_png(const std::string& bytes, const std::string& name) {
  const PngRows rows = read_png_rows(bytes, name, PngPixels::rgba, {.side = max_picture_side});
  TransparentImage result{image_of(rows), {}};
  for (std::size_t i = 0; i < rows.bytes.size(); i += 4) {
    result.image.pixels.emplace_back(rows.bytes[i], rows.bytes[i + 1], rows.bytes[i + 2]);
    result.opacity.push_back(rows.bytes[i + 3]);
  }
  return result;
}

DeepImage read_deep_png(const std::string& bytes, const std::string& name) {
  const PngRows rows = read_png_rows(bytes, name, PngPixels::sixteen, {.side = max_picture_side});
  DeepImage image{.width = rows.width, .height = rows.height, .channels = rows.channels, .values = {}};
  for (std::size_t i = 0; i < rows.bytes.size(); i += 2)
    image.values.push_back(static_cast<std::uint16_t>(rows.bytes[i] << 8 | rows.bytes[i + 1]));
  return image;
}

}  // namespace pomona
