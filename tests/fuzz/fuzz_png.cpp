// A picture. Each chunk ends with a checksum, which mutations make wrong. Seven inputs in eight are corrected after the
// mutation, so that the code behind the checksums is reached.
#include <cstddef>
#include <cstdint>
#include <string>

#include "render/image/png.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed);

namespace {

constexpr std::size_t signature = 8, head = 8, checksum = 4;  // bytes

std::size_t word_at(const std::uint8_t* at) {
  return std::size_t{at[0]} << 24 | std::size_t{at[1]} << 16 | std::size_t{at[2]} << 8 | at[3];
}

/// PNG's specification, "CRC algorithm".
std::uint32_t checksum_of(const std::uint8_t* data, std::size_t size) {
  std::uint32_t sum = ~std::uint32_t{0};
  for (std::size_t i = 0; i < size; ++i) {
    sum ^= data[i];
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? sum >> 1 ^ 0xEDB88320u : sum >> 1;
  }
  return ~sum;
}

/// A chunk is the length of its bytes, its kind, its bytes, and the checksum of the last two.
void set_checksums(std::uint8_t* data, std::size_t size) {
  for (std::size_t at = signature; at + head + checksum <= size;) {
    const std::size_t length = word_at(data + at);
    if (length > size - at - head - checksum) return;
    const std::uint32_t sum = checksum_of(data + at + 4, length + 4);
    for (std::size_t k = 0; k < 4; ++k)
      data[at + head + length + k] = static_cast<std::uint8_t>(sum >> (24 - 8 * k) & 255);
    at += head + length + checksum;
  }
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  const std::size_t now = LLVMFuzzerMutate(data, size, max);
  if (seed % 8 != 0) set_checksums(data, now);
  return now;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] {
    // Half of the inputs go to each reader: without and with opacity.
    size % 2 == 0 ? static_cast<void>(pomona::read_png(bytes, "fuzz.png"))
                  : static_cast<void>(pomona::read_transparent_png(bytes, "fuzz.png"));
  });
}
