// A reader with a planted fault: after four letters, which the fuzzer must find one by one, it reads past the end of
// its input. scripts/fuzz.py must report it; tests/fuzz/fuzz_test.py checks that.
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
