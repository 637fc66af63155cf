// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/error.h"

namespace pomona {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< lists alone
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t byte = 0;  ///< where the header declares it
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;
  std::size_t size = 0;  ///< bytes up to the first value
};

/// \throws Error (bad_data) with line and column.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& file);

/// The place of a byte in a text.
SourcePlace place_in_text(std::string_view bytes, std::size_t byte, const std::string& file);

}  // namespace pomona
