// Faults of a settled piece, just below and just above each limit.
#include "generator/scene/settle/faults.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

constexpr double just_above = 1 + 1e-9;

TEST(Faults, BeginAboveTheLimitsThatSettlingPromises) {
  const SettleOptions options;
  EXPECT_EQ(options.max_gap, 0.02);
  EXPECT_EQ(options.max_penetration, 0.02);
  EXPECT_FALSE(fault_of(3, {.gap = 0.02, .penetration = 0.02}, options));
  const auto gap = fault_of(3, {.gap = 0.02 * just_above}, options);
  const auto overlap = fault_of(3, {.penetration = 0.02 * just_above}, options);
  ASSERT_TRUE(gap && overlap);
  EXPECT_EQ(gap->piece, 3u);
  EXPECT_EQ(gap->what, "keeps a gap of 2.0 % of its size");
  EXPECT_EQ(overlap->what, "overlaps by 2.0 % of its size");
}

TEST(Faults, AreGraveAboveWhatFewMayHave) {
  const SettleOptions options;
  EXPECT_EQ(options.max_rare_fault, 0.05);
  EXPECT_FALSE(fault_of(0, {.gap = 0.05}, options)->is_severe);
  EXPECT_TRUE(fault_of(0, {.gap = 0.05 * just_above}, options)->is_severe);
  EXPECT_FALSE(fault_of(0, {.penetration = 0.05}, options)->is_severe);
  EXPECT_TRUE(fault_of(0, {.penetration = 0.05 * just_above}, options)->is_severe);
}

TEST(Faults, MayStayWhereTheyAreSmallAndOneOfTwoHundred) {
  const SettleOptions options;
  const Fault small{0, "overlaps", false}, severe{0, "overlaps", true};
  EXPECT_TRUE(are_acceptable({}, 1, options));
  EXPECT_TRUE(are_acceptable({small}, 200, options));
  EXPECT_FALSE(are_acceptable({small}, 199, options));
  EXPECT_FALSE(are_acceptable({small, small}, 399, options));
  EXPECT_FALSE(are_acceptable({severe}, 100000, options));
}

}  // namespace
}  // namespace pomona
