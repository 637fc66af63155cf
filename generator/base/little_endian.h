// Plain values as bytes, lowest byte first (little-endian), for our binary files and for glTF.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pomona {

/// Appends values to bytes.
class ByteWriter {
 public:
  explicit ByteWriter(std::string bytes = {}) : bytes_(std::move(bytes)) {}

  void add(std::uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  void add(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<char>((value >> shift) & 0xff));
  }
  void add(std::int32_t value) { add(static_cast<std::uint32_t>(value)); }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  void add(const glm::vec3& value) {
    for (int k = 0; k < 3; ++k) add(value[k]);
  }
  void add(const glm::vec4& value) {
    for (int k = 0; k < 4; ++k) add(value[k]);
  }
  void reserve(std::size_t size) { bytes_.reserve(size); }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// The four bytes of a whole number below 2^32.
inline std::string word_bytes(std::size_t number) {
  ByteWriter bytes;
  bytes.add(static_cast<std::uint32_t>(number));
  return bytes.take();
}

/// The whole number whose four bytes begin at `at`. The bytes must be there.
inline std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t b = 4; b-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + b]);
  return word;
}

}  // namespace pomona
