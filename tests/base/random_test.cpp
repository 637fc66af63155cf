#include "generator/base/random.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(Random, philox_gives_the_published_answer) {
  // Random123's known answer of philox4x32-10 for a counter and key of zeros; this index cancels the purpose's
  // hash (FNV-1a), which shares its word of the counter.
  std::uint32_t hash = 2166136261u;
  for (const char c : {'k', 'a', 't'}) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  const RandomStream zeros({0, static_cast<std::uint64_t>(hash) << 32}, "kat");
  EXPECT_EQ(zeros.bits(0), 0xe169c58d6627e8d5u);
}

TEST(Random, a_stream_is_frozen) {
  // A change of these numbers changes all variants that were ever made.
  const RandomStream stream({1, 2}, "frozen");
  EXPECT_EQ(stream.bits(0), 12131809914034332202u);
  EXPECT_EQ(stream.bits(1), 13440658807520601897u);
  EXPECT_EQ(stream.below(7, 1000), 291u);
}

TEST(Random, streams_differ_by_seed_index_and_purpose) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (std::uint64_t index = 0; index < 4; ++index) {
      for (const char* purpose : {"fold", "grains", "pile"}) {
        for (std::uint64_t n = 0; n < 4; ++n) seen.insert(RandomStream({seed, index}, purpose).bits(n));
      }
    }
  }
  EXPECT_EQ(seen.size(), 4u * 4 * 3 * 4);
}

TEST(Random, uniform_and_normal_have_their_moments) {
  const RandomStream stream({5, 0}, "moments");
  constexpr int count = 100000;
  double mean = 0, normal_mean = 0, normal_square = 0;
  for (std::uint64_t n = 0; n < count; ++n) {
    const double u = stream.uniform(n), z = stream.normal(n);
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ASSERT_LE(std::fabs(z), 6.0);
    mean += u / count;
    normal_mean += z / count;
    normal_square += z * z / count;
  }
  EXPECT_NEAR(mean, 0.5, 0.005);
  EXPECT_NEAR(normal_mean, 0, 0.02);
  EXPECT_NEAR(normal_square, 1, 0.02);
}

TEST(Random, below_stays_below) {
  const RandomStream stream({6, 0}, "below");
  std::set<std::uint64_t> seen;
  for (std::uint64_t n = 0; n < 1000; ++n) seen.insert(stream.below(n, 7));
  EXPECT_EQ(seen, (std::set<std::uint64_t>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(stream.below(0, 1), 0u);
}

}  // namespace
}  // namespace pomona
