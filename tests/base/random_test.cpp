#include "generator/base/random.h"

#include <cmath>
#include <set>

#include <Random123/philox.h>
#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(Random, philox_gives_the_published_answers) {
  // The known-answer vectors of Random123, philox4x32-10.
  const r123::Philox4x32::ctr_type zeros = {{0, 0, 0, 0}};
  const r123::Philox4x32::key_type zero_key = {{0, 0}};
  const auto first = r123::Philox4x32()(zeros, zero_key);
  EXPECT_EQ(first[0], 0x6627e8d5u);
  EXPECT_EQ(first[1], 0xe169c58du);
  EXPECT_EQ(first[2], 0xbc57ac4cu);
  EXPECT_EQ(first[3], 0x9b00dbd8u);
}

TEST(Random, a_stream_is_frozen) {
  // Whoever changes these changes every variant that was ever made.
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
