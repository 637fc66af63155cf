#include "cli/verify/verified_cut.h"

namespace pomona {

namespace {

/// Any number that depends on the name alone.
std::uint64_t number_of(const std::string& name) {
  std::uint64_t sum = 0;
  for (const char letter : name) sum += static_cast<unsigned char>(letter);
  return sum;
}

}  // namespace

bool in_the_tenth(const VerifiedCut& cut) {
  return (number_of(cut.fruit) + 3 * number_of(cut.knife) + cut.seed) % verified_seeds == 0;
}

}  // namespace pomona
