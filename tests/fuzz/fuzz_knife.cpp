// A knife in the notation of the command line and of scenes.
#include <cstddef>
#include <cstdint>
#include <string>

#include "generator/knife/parse_knife.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told_words([&] { pomona::parse_knife(bytes, "nowhere"); });
}
