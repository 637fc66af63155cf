#include "generator/base/first_bytes.h"

#include <algorithm>

namespace pomona {

std::string first_bytes(std::istream& stream, std::size_t max) {
  constexpr std::size_t at_once = std::size_t{1} << 16;
  std::string bytes;
  while (stream && bytes.size() < max) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(at_once, max - before));
    stream.read(bytes.data() + before, static_cast<std::streamsize>(bytes.size() - before));
    bytes.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  return bytes;
}

}  // namespace pomona
