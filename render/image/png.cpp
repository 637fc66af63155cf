#include "render/image/png.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <png.h>
#include <glm/vec4.hpp>

#include "generator/base/error.h"
#include "render/image/deep_image.h"

namespace pomona {

namespace {

constexpr double max_pixels = 1e8;  // limit of pixels of a picture that is read

/// The file, for messages.
struct PngName {
  std::string file;
  std::size_t bytes = 0;  ///< size of a file that is read
  std::string_view rest;  ///< bytes that have not been read yet
};

// libpng's own way out of errors is longjmp; an exception thrown from its callback unwinds this side only, so the
// structures are owned by destructors here.
[[noreturn]] void fail(png_structp png, png_const_charp message) {
  const auto* name = static_cast<const PngName*>(png_get_error_ptr(png));
  const std::string element = "byte " + std::to_string(name->bytes - name->rest.size());
  throw Error(ExitStatus::bad_data, {{{name->file, 0, 0, element}, std::string("not a readable PNG: ") + message, ""}});
}

void ignore(png_structp, png_const_charp) {}

struct Writer {
  PngName name{"picture", 0, {}};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &name, fail, ignore);
  png_infop info = png_create_info_struct(png);
  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct PngReader {
  PngName name;
  png_structp png = nullptr;
  png_infop info = nullptr;
  PngReader(const std::string& bytes, std::string file) : name{std::move(file), bytes.size(), bytes} {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &name, fail, ignore);
    info = png_create_info_struct(png);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

void take(png_structp png, png_bytep data, png_size_t size) {
  std::string_view& rest = static_cast<PngName*>(png_get_io_ptr(png))->rest;
  if (rest.size() < size) png_error(png, "it ends too early");
  std::memcpy(data, rest.data(), size);
  rest.remove_prefix(size);
}

}  // namespace

namespace {

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

/// Checks size and kind before memory for pixels is allocated. Deflate shrinks at most 1032 times, so few bytes cannot
/// hold many pixels.
void read_head(PngReader& reader) {
  png_set_read_fn(reader.png, &reader.name, take);
  png_set_user_limits(reader.png, max_picture_side, max_picture_side);
  png_read_info(reader.png, reader.info);
  const auto pixels = static_cast<double>(png_get_image_width(reader.png, reader.info)) *
                      static_cast<double>(png_get_image_height(reader.png, reader.info));
  const int bits = png_get_bit_depth(reader.png, reader.info) * png_get_channels(reader.png, reader.info);
  if (pixels > max_pixels) png_error(reader.png, "it has more than 100 million pixels");
  if (pixels * bits / 8 > 1040.0 * static_cast<double>(reader.name.bytes))
    png_error(reader.png, "it claims more pixels than its bytes can hold");
}

/// Converts any PNG to eight-bit RGBA, or RGB without opacity. The image has its size, but no pixels yet.
Image start_reading(PngReader& reader, bool with_opacity) {
  read_head(reader);
  png_set_expand(reader.png);
  png_set_strip_16(reader.png);
  if (with_opacity) {
    png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
  } else {
    png_set_strip_alpha(reader.png);
  }
  png_set_gray_to_rgb(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return {.width = static_cast<int>(png_get_image_width(reader.png, reader.info)),
          .height = static_cast<int>(png_get_image_height(reader.png, reader.info)),
          .pixels = {}};
}

/// Rows of `width` elements, one after another in `pixels`.
void read_rows(PngReader& reader, std::uint8_t* pixels, const Image& image, std::size_t bytes_each) {
  std::vector<png_bytep> rows;
  for (int y = 0; y < image.height; ++y) {
    rows.push_back(pixels + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * bytes_each);
  }
  png_read_image(reader.png, rows.data());
}

}  // namespace

Image read_png(const std::string& bytes, const std::string& name) {
  PngReader reader(bytes, name);
  Image image = start_reading(reader, false);
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  read_rows(reader, reinterpret_cast<std::uint8_t*>(image.pixels.data()), image, 3);
  return image;
}

TransparentImage read_transparent_png(const std::string& bytes, const std::string& name) {
  PngReader reader(bytes, name);
  TransparentImage result{start_reading(reader, true), {}};
  std::vector<glm::u8vec4> pixels(static_cast<std::size_t>(result.image.width) * result.image.height);
  read_rows(reader, reinterpret_cast<std::uint8_t*>(pixels.data()), result.image, 4);
  for (const glm::u8vec4& pixel : pixels) {
    result.image.pixels.emplace_back(pixel);
    result.opacity.push_back(pixel.a);
  }
  return result;
}

DeepImage read_deep_png(const std::string& bytes, const std::string& name) {
  PngReader reader(bytes, name);
  read_head(reader);
  const int channels = png_get_channels(reader.png, reader.info);
  if (png_get_bit_depth(reader.png, reader.info) != 16 || (channels != 1 && channels != 3))
    png_error(reader.png, "it is not 16-bit grey or RGB");
  DeepImage image{.width = static_cast<int>(png_get_image_width(reader.png, reader.info)),
                  .height = static_cast<int>(png_get_image_height(reader.png, reader.info)),
                  .channels = channels,
                  .values = {}};
  std::vector<std::uint8_t> raw(2 * static_cast<std::size_t>(image.width) * image.height * channels);
  read_rows(reader, raw.data(), {image.width, image.height, {}}, 2 * static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < raw.size(); i += 2)
    image.values.push_back(static_cast<std::uint16_t>(raw[i] << 8 | raw[i + 1]));
  return image;
}

}  // namespace pomona
