// A picture.
#include <cstddef>
#include <cstdint>
#include <string>

#include "render/image/png.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] {
    // What is drawn over it wants its opacity; what is compared does not.
    size % 2 == 0 ? static_cast<void>(pomona::read_png(bytes, "fuzz.png"))
                  : static_cast<void>(pomona::read_transparent_png(bytes, "fuzz.png"));
  });
}
