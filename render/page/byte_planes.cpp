#include "render/page/byte_planes.h"

#include "generator/base/little_endian.h"

namespace pomona {

namespace {

/// All ones in the lowest bytes.
std::uint32_t mask_of(std::size_t width) { return static_cast<std::uint32_t>((std::uint64_t{1} << (8 * width)) - 1); }

/// A difference with its highest bit set is negative: negative ones become odd numbers, others even ones.
std::uint32_t folded(std::uint32_t difference, std::size_t width) {
  const bool negative = (difference >> (8 * width - 1) & 1) != 0;
  return ((difference << 1) ^ (negative ? ~std::uint32_t{0} : 0)) & mask_of(width);
}

std::uint32_t unfolded(std::uint32_t symbol) { return (symbol >> 1) ^ ((symbol & 1) != 0 ? ~std::uint32_t{0} : 0); }

}  // namespace

std::string as_planes(std::span<const std::uint32_t> numbers, std::size_t back, std::size_t width) {
  std::string bytes(numbers.size() * width, '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::uint32_t before = i >= back ? numbers[i - back] : 0;
    const std::uint32_t symbol = folded((numbers[i] - before) & mask_of(width), width);
    for (std::size_t b = 0; b < width; ++b) bytes[b * numbers.size() + i] = static_cast<char>(symbol >> (8 * b) & 255);
  }
  return bytes;
}

std::vector<std::uint32_t> from_planes(std::string_view bytes, std::size_t back, std::size_t width) {
  std::vector<std::uint32_t> numbers(bytes.size() / width);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint32_t symbol = 0;
    for (std::size_t b = 0; b < width; ++b)
      symbol |= std::uint32_t{static_cast<unsigned char>(bytes[b * numbers.size() + i])} << (8 * b);
    numbers[i] = (unfolded(symbol) + (i >= back ? numbers[i - back] : 0)) & mask_of(width);
  }
  return numbers;
}

std::string texel_bytes(std::span<const glm::vec4> texels) {
  ByteWriter bytes;
  for (const glm::vec4& texel : texels) bytes.add(texel);
  return bytes.take();
}

}  // namespace pomona
