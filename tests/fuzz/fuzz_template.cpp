// A template: TOML, curves, ramps, grains, coats; the files that it names do not exist.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/template/read/read_template.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] { pomona::parse_template(bytes, "nowhere/fuzz.toml"); });
}
