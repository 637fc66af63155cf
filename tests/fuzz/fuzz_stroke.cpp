// A knife's path in an SVG: a stroke, or a profile to revolve.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/knife/read_stroke.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] {
    pomona::parse_stroke(bytes, "fuzz.svg", "wave", 1e-3);
    pomona::parse_profile(bytes, "fuzz.svg", "ring", 1e-3);
  });
}
