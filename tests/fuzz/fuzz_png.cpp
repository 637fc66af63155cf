// A picture. Each chunk ends with a checksum, which no mutation hits: they are set right after the mutation, but for
// one input in eight, so that what lies behind them is reached.
#include <cstddef>
#include <cstdint>
#include <string>

#include <png.h>
#include <zlib.h>

#include "render/image/png.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace {

constexpr std::size_t signature = 8, head = 8, checksum = 4;  // bytes

/// Of the length of a chunk, its kind and bytes: the checksum of the last two.
void set_checksums(std::uint8_t* data, std::size_t size) {
  for (std::size_t at = signature; at + head + checksum <= size;) {
    const std::size_t length = png_get_uint_32(data + at);
    if (length > size - at - head - checksum) return;
    png_save_uint_32(data + at + head + length,
                     static_cast<png_uint_32>(crc32(0, data + at + 4, static_cast<unsigned>(length + 4))));
    at += head + length + checksum;
  }
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const std::size_t now = LLVMFuzzerMutate(data, size, most);
  if (seed % 8 != 0) set_checksums(data, now);
  return now;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] {
    // What is drawn over it wants its opacity; what is compared does not.
    size % 2 == 0 ? static_cast<void>(pomona::read_png(bytes, "fuzz.png"))
                  : static_cast<void>(pomona::read_transparent_png(bytes, "fuzz.png"));
  });
}
