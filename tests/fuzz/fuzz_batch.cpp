// A batch file; the files that it names do not exist.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/batch/batch_file.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] { pomona::parse_batch(bytes, "nowhere/fuzz.toml"); });
}
