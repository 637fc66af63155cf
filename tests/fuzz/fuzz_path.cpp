// Path data of SVG and templates.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/text/svg_path.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    pomona::parse_svg_path(bytes);
  } catch (const pomona::BadPath&) {
  }
  return 0;
}
