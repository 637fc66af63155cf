#include "render/image/hdr.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "generator/base/error.h"

namespace pomona {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;  ///< red, green, blue, and the exponent of all three

/// A whole number behind a word: 512 of "-Y 512".
std::optional<int> number_behind(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return {};
  text.remove_prefix(word.size());
  int number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || number < 1) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

class HdrReader {
 public:
  HdrReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  LinearImage read() {
    LinearImage picture = size_told();
    const auto width = static_cast<std::size_t>(picture.width);
    std::vector<Rgbe> row(width);
    for (int y = 0; y < picture.height; ++y) {
      read_row(row);
      for (const Rgbe& pixel : row) picture.pixels.push_back(light_of(pixel));
    }
    return picture;
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    throw Error(ExitStatus::bad_data, {{{name_, 0, 0, "byte " + std::to_string(at_)}, message, hint}});
  }

  std::string_view line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) fail("the header has no end");
    const std::string_view text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  /// Reads the header: words, an empty line, and the size. The picture has no pixels yet.
  LinearImage size_told() {
    while (true) {
      const std::string_view text = line();
      if (text.empty()) break;
      if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe")
        fail("is not of red, green and blue", "FORMAT=32-bit_rle_rgbe is read");
    }
    std::string_view text = line();
    const auto height = number_behind(text, "-Y "), width = height ? number_behind(text, " +X ") : std::nullopt;
    if (!width || !text.empty()) fail("says no size that is read", "it should be as in \"-Y 512 +X 1024\"");
    if (*width > max_hdr_side || *height > max_hdr_side / 2)
      fail("is larger than " + std::to_string(max_hdr_side) + " x " + std::to_string(max_hdr_side / 2) + " pixels");
    // How many pixels follow is not known from the bytes, for runs may be long: memory grows as rows are read.
    return {*width, *height, {}};
  }

  std::uint8_t next() {
    if (at_ >= bytes_.size()) fail("ends before its last row");
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }

  Rgbe next_pixel() {
    Rgbe pixel;
    for (std::uint8_t& value : pixel) value = next();
    return pixel;
  }

  void read_row(std::vector<Rgbe>& row) {
    const Rgbe first = next_pixel();
    const std::size_t told = std::size_t{first[2]} << 8 | first[3];
    if (row.size() < 8 || first[0] != 2 || first[1] != 2 || first[2] >= 128) return read_old_row(first, row);
    if (told != row.size()) fail("a row is " + std::to_string(told) + " pixels wide");
    for (std::size_t channel = 0; channel < 4; ++channel) read_channel(channel, row);
  }

  /// Runs of one value, and values as they are.
  void read_channel(std::size_t channel, std::vector<Rgbe>& row) {
    constexpr std::size_t longest = 128;
    for (std::size_t x = 0; x < row.size();) {
      std::size_t count = next();
      const bool is_run = count > longest;
      if (is_run) count -= longest;
      if (count == 0 || x + count > row.size()) fail("a run leads beyond its row");
      const std::uint8_t value = is_run ? next() : std::uint8_t{0};
      for (; count > 0; --count) row[x++][channel] = is_run ? value : next();
    }
  }

  /// Pixels as they are; (1, 1, 1, n) repeats the last one, and further ones in turn count 256 times as much.
  void read_old_row(Rgbe pixel, std::vector<Rgbe>& row) {
    int shift = 0;
    for (std::size_t x = 0;;) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = shift < 24 ? std::size_t{pixel[3]} << shift : row.size() + 1;
        if (x == 0 || x + count > row.size()) fail("a run leads beyond its row");
        const Rgbe last = row[x - 1];
        for (std::size_t k = 0; k < count; ++k) row[x++] = last;
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x == row.size()) return;
      pixel = next_pixel();
    }
  }

  static Color light_of(const Rgbe& pixel) {
    if (pixel[3] == 0) return Color(0);
    constexpr int bias = 128 + 8;
    const float scale = std::ldexp(1.0f, pixel[3] - bias);
    return {scale * pixel[0], scale * pixel[1], scale * pixel[2]};
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_hdr(std::string_view bytes) { return bytes.starts_with("#?"); }

LinearImage read_hdr(std::string_view bytes, const std::string& name) { return HdrReader(bytes, name).read(); }

}  // namespace pomona
