// A picture of light. Its header is words, its rows are bytes without a checksum.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render/image/hdr.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] { pomona::read_hdr(bytes, "fuzz.hdr"); });
}
