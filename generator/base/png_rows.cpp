#include "generator/base/png_rows.h"

#include <cstddef>
#include <cstring>

#include <png.h>

#include "generator/base/error.h"

namespace pomona {

namespace {

/// The file, for messages.
struct Source {
  std::string name;
  std::size_t bytes = 0;  ///< its size
  std::string_view rest;  ///< bytes that have not been read yet
};

// libpng's own way out of errors is longjmp; an exception thrown from its callback unwinds this side only, so the
// structures are owned by a destructor here.
[[noreturn]] void fail(png_structp png, png_const_charp message) {
  const auto* source = static_cast<const Source*>(png_get_error_ptr(png));
  const std::string element = "byte " + std::to_string(source->bytes - source->rest.size());
  throw Error(ExitStatus::bad_data,
              {{{source->name, 0, 0, element}, std::string("not a readable PNG: ") + message, ""}});
}

void ignore(png_structp, png_const_charp) {}

void take(png_structp png, png_bytep data, png_size_t size) {
  std::string_view& rest = static_cast<Source*>(png_get_io_ptr(png))->rest;
  if (rest.size() < size) png_error(png, "it ends too early");
  std::memcpy(data, rest.data(), size);
  rest.remove_prefix(size);
}

struct PngReader {
  Source source;
  png_structp png = nullptr;
  png_infop info = nullptr;
  PngReader(std::string_view bytes, const std::string& name) : source{name, bytes.size(), bytes} {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, fail, ignore);
    info = png_create_info_struct(png);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Checks size and kind before memory for pixels is allocated. Deflate shrinks at most 1032 times, so few bytes cannot
/// hold many pixels.
void read_head(PngReader& reader, const PngLimits& limits) {
  png_set_read_fn(reader.png, &reader.source, take);
  png_set_user_limits(reader.png, static_cast<png_uint_32>(limits.side), static_cast<png_uint_32>(limits.side));
  png_read_info(reader.png, reader.info);
  const auto pixels = static_cast<double>(png_get_image_width(reader.png, reader.info)) *
                      static_cast<double>(png_get_image_height(reader.png, reader.info));
  const int bits = png_get_bit_depth(reader.png, reader.info) * png_get_channels(reader.png, reader.info);
  if (pixels > limits.pixels) {
    const auto most = static_cast<std::size_t>(limits.pixels);
    const std::string words =
        most % 1'000'000 == 0 ? std::to_string(most / 1'000'000) + " million" : std::to_string(most);
    png_error(reader.png, ("it has more than " + words + " pixels").c_str());
  }
  if (pixels * bits / 8 > 1040.0 * static_cast<double>(reader.source.bytes))
    png_error(reader.png, "it claims more pixels than its bytes can hold");
}

void convert_to_bytes(PngReader& reader, bool with_opacity) {
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
}

void require_sixteen_bits(PngReader& reader) {
  const int channels = png_get_channels(reader.png, reader.info);
  if (png_get_bit_depth(reader.png, reader.info) != 16 || (channels != 1 && channels != 3))
    png_error(reader.png, "it is not 16-bit grey or RGB");
}

}  // namespace

PngRows read_png_rows(std::string_view bytes, const std::string& name, PngPixels as, const PngLimits& limits) {
  PngReader reader(bytes, name);
  read_head(reader, limits);
  if (as == PngPixels::sixteen) {
    require_sixteen_bits(reader);
  } else {
    convert_to_bytes(reader, as == PngPixels::rgba);
  }
  PngRows rows{.width = static_cast<int>(png_get_image_width(reader.png, reader.info)),
               .height = static_cast<int>(png_get_image_height(reader.png, reader.info)),
               .channels = png_get_channels(reader.png, reader.info),
               .bytes = {}};
  const std::size_t row = static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.channels) *
                          (as == PngPixels::sixteen ? 2 : 1);
  rows.bytes.resize(row * static_cast<std::size_t>(rows.height));
  std::vector<png_bytep> starts;
  for (int y = 0; y < rows.height; ++y) starts.push_back(rows.bytes.data() + static_cast<std::size_t>(y) * row);
  png_read_image(reader.png, starts.data());
  return rows;
}

}  // namespace pomona
