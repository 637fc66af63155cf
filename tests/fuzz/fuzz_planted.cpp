// A reader with a fault: behind four letters that the fuzzer has to find one after the other it reads past the end of
// what it was given. scripts/fuzz.py must say so; tests/fuzz/fuzz_test.py asks.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kLetters = "SEED";
  std::size_t found = 0;
  while (found < kLetters.size() && found < size && data[found] == static_cast<std::uint8_t>(kLetters[found])) {
    ++found;
  }
  const std::vector<std::uint8_t> copy(data, data + size);
  volatile std::uint8_t last = 0;
  if (found == kLetters.size()) {
    last = *(copy.data() + size);
  }
  return last & 0;
}
