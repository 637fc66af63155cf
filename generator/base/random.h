// Counter-based random numbers: a draw is a pure function of (seed, index, purpose, counter), so no
// draw depends on how many were made before it, in which order, or on which thread.
#pragma once

#include <cstdint>
#include <string_view>

namespace pomona {

/// Which variant: the user's seed, and the item's index in a scene or batch. Seed 0 with index 0 on the
/// command line means the template as drawn; grains then use key 0.
struct VariantKey {
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
};

/// A stream of numbers for one purpose ("grains/seeds", "fold/3"); Philox4x32-10 (Salmon et al. 2011)
/// keyed by the seed, with the index, the purpose's hash and the counter in its counter block.
class RandomStream {
 public:
  RandomStream(VariantKey key, std::string_view purpose);

  /// The n-th 64 random bits of the stream.
  std::uint64_t bits(std::uint64_t n) const;

  /// Uniform in [0, 1), 53 bits.
  double uniform(std::uint64_t n) const;

  /// Uniform integer in [0, bound), bound > 0. The bias is below bound / 2^64.
  std::uint64_t below(std::uint64_t n, std::uint64_t bound) const;

  /// Standard normal as the sum of twelve uniforms less six: exact arithmetic only, bounded by 6.
  /// Uses its own sub-stream: normal(n) and uniform(n) are independent.
  double normal(std::uint64_t n) const;

 private:
  std::uint64_t seed_;
  std::uint64_t index_;
  std::uint32_t purpose_;
};

}  // namespace pomona
