#include "cli/sketch/picture_file.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

#include "generator/base/base64.h"
#include "generator/base/error.h"
#include "generator/base/path_within.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::uintmax_t max_bytes = std::uintmax_t{256} << 20;
constexpr double max_pixels = 1e8;

[[noreturn]] void fail(const std::string& place, const std::string& message, const std::string& hint,
                       ExitStatus status = ExitStatus::bad_data) {
  throw Error(status, {{{place, 0, 0, {}}, message, hint}});
}

/// Reports a fault of a PNG's head, at its byte.
[[noreturn]] void fail_at(int byte, const std::string& place, const std::string& message, const std::string& hint) {
  throw Error(ExitStatus::bad_data, {{{place, 0, 0, "byte " + std::to_string(byte)}, message, hint}});
}

/// Width and height from a PNG's first chunk.
glm::dvec2 png_size(const std::string& bytes, const std::string& place) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  if (bytes.size() < 24 || std::string_view(bytes).substr(0, 16) != signature) {
    fail_at(0, place, "the picture is no PNG", "convert it: `convert photo.jpg photo.png`, or export it as PNG");
  }
  const auto number = [&](std::size_t at) {
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  const glm::dvec2 size(number(16), number(20));
  if (!(size.x >= 1 && size.y >= 1)) fail_at(16, place, "the picture has no pixels", "make it anew");
  if (size.x * size.y > max_pixels) {
    fail_at(16, place, "the picture has more than 100 million pixels",
            "make it smaller: 2000 pixels a side are plenty");
  }
  return size;
}

std::optional<int> hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return {};
}

std::string uri_decoded(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto high = i + 2 < text.size() ? hex_digit(text[i + 1]) : std::nullopt;
    const auto low = i + 2 < text.size() ? hex_digit(text[i + 2]) : std::nullopt;
    if (text[i] == '%' && high && low) {
      result.push_back(static_cast<char>(16 * *high + *low));
      i += 2;
    } else {
      result.push_back(text[i]);
    }
  }
  return result;
}

std::string uri_encoded(const std::string& text) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~/";
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    if (plain.find(c) != std::string_view::npos) {
      result.push_back(c);
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    result += {'%', digits[byte >> 4], digits[byte & 15u]};
  }
  return result;
}

}  // namespace

std::string picture_bytes(const fs::path& file, const std::string& place) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    fail(place, "the picture " + file.string() + " is not there", "put it back, or keep the colours as they are",
         ExitStatus::input_missing);
  }
  if (fs::file_size(file, ignored) > max_bytes) fail(place, "the picture is larger than 256 MiB", "make it smaller");
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

LinkedPicture linked_picture(const fs::path& step, const std::string& bytes, const std::string& file) {
  return {uri_encoded(step.generic_string()), png_size(bytes, file)};
}

TransparentImage read_linked_picture(const std::string& href, const fs::path& folder, const std::string& place) {
  std::string bytes;
  if (href.starts_with("data:")) {
    const std::size_t comma = href.find(',');
    const bool is_base64 = comma != std::string::npos && href.substr(0, comma).ends_with(";base64");
    const auto decoded = is_base64 ? base64_decoded(std::string_view(href).substr(comma + 1)) : std::nullopt;
    if (!decoded) fail(place, "the embedded picture is not base64", "embed it anew, or link it");
    bytes = *decoded;
  } else {
    const fs::path relative = fs::path(uri_decoded(href)).lexically_normal();
    const fs::path file = folder / relative;
    if (href.find(':') != std::string::npos || relative.is_absolute() || !path_within(folder, file)) {
      fail(place, "the picture lies outside the template's folder",
           "put it beside the template and link it anew, or embed it (Extensions > Images > Embed Images)");
    }
    bytes = picture_bytes(file, place);
  }
  png_size(bytes, place);
  return read_transparent_png(bytes, place);
}

TransparentImage read_picture(const fs::path& file) {
  const std::string place = file.string(), bytes = picture_bytes(file, place);
  png_size(bytes, place);
  return read_transparent_png(bytes, place);
}

}  // namespace pomona
