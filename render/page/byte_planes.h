// Whole numbers as bytes that zlib packs well: differences from earlier ones, small ones first, low bytes together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>

namespace pomona {

/// Each number becomes its difference from the one `back` before it (from 0 at the start), modulo 2^(8 width), folded
/// so that 0, -1, 1, -2 become 0, 1, 2, 3. All lowest bytes come first, then all second ones, and so on.
/// \param width 1 to 4 bytes; numbers must be below 2^(8 width)
std::string as_planes(std::span<const std::uint32_t> numbers, std::size_t back, std::size_t width);

/// The planes of one number per element, get(0) to get(elements - 1).
template <typename Get>
std::string planes_of(std::size_t elements, std::size_t back, std::size_t width, const Get& get) {
  std::vector<std::uint32_t> numbers(elements);
  for (std::size_t i = 0; i < elements; ++i) numbers[i] = static_cast<std::uint32_t>(get(i));
  return as_planes(numbers, back, width);
}

/// The opposite of as_planes(); `bytes` has width * count of them.
std::vector<std::uint32_t> from_planes(std::string_view bytes, std::size_t back, std::size_t width);

/// Texels without coding, four floats each.
std::string texel_bytes(std::span<const glm::vec4> texels);

}  // namespace pomona
