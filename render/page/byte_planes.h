// Whole numbers as bytes that zlib packs well: differences from earlier ones, small ones first, low bytes together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pomona {

/// Each number becomes its difference from the one `back` before it (from 0 at the start), modulo 2^(8 width), folded
/// so that 0, -1, 1, -2 become 0, 1, 2, 3. All lowest bytes come first, then all second ones, and so on. \param width 1
/// to 4 bytes; numbers must be below 2^(8 width)
std::string as_planes(std::span<const std::uint32_t> numbers, std::size_t back, std::size_t width);

/// The opposite; `bytes` has width * count of them.
std::vector<std::uint32_t> from_planes(std::string_view bytes, std::size_t back, std::size_t width);

}  // namespace pomona
