// A mesh as binary glTF.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/surface/file/glb_file.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] { pomona::parse_glb(bytes, "fuzz.glb", size % 2 == 0 ? "" : "lid"); });
}
