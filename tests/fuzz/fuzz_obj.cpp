// A mesh as Wavefront OBJ.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/surface/file/obj_file.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] { pomona::parse_obj(bytes, "fuzz.obj", size % 2 == 0 ? "" : "lid"); });
}
