#include "generator/base/random.h"

#include <Random123/philox.h>

namespace pomona {

namespace {

/// FNV-1a; only has to tell a handful of purposes apart.
std::uint32_t hash_of(std::string_view purpose) {
  std::uint32_t hash = 2166136261u;
  for (const char c : purpose) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}

std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

}  // namespace

RandomStream::RandomStream(VariantKey key, std::string_view purpose)
    : seed_(key.seed), index_(key.index), purpose_(hash_of(purpose)) {}

std::uint64_t RandomStream::bits(std::uint64_t n) const {
  // The counter block is (draw, index, purpose); the upper half of the index joins the purpose, which
  // keeps all 64-bit seeds and the first 2^32 draws and indices apart.
  const r123::Philox4x32::ctr_type counter = {{low(n), high(n), low(index_), purpose_ ^ high(index_)}};
  const r123::Philox4x32::key_type key = {{low(seed_), high(seed_)}};
  const auto block = r123::Philox4x32()(counter, key);
  return (static_cast<std::uint64_t>(block[1]) << 32) | block[0];
}

double RandomStream::uniform(std::uint64_t n) const { return static_cast<double>(bits(n) >> 11) * 0x1p-53; }

std::uint64_t RandomStream::below(std::uint64_t n, std::uint64_t bound) const {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>((static_cast<Wide>(bits(n)) * bound) >> 64);
}

double RandomStream::normal(std::uint64_t n) const {
  constexpr std::uint64_t sub_stream = std::uint64_t{1} << 62;
  double sum = -6.0;
  for (std::uint64_t k = 0; k < 12; ++k) sum += uniform(sub_stream + 12 * n + k);
  return sum;
}

}  // namespace pomona
