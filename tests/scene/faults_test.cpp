// What may be wrong with a settled piece: limits met from both sides.
#include "generator/scene/settle/faults.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

constexpr double just_above = 1 + 1e-9;

TEST(Faults, BeginAboveTheLimitsThatSettlingPromises) {
  const SettleOptions options;
  EXPECT_EQ(options.most_gap, 0.02);
  EXPECT_EQ(options.most_penetration, 0.02);
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
  EXPECT_EQ(options.most_of_few, 0.05);
  EXPECT_FALSE(fault_of(0, {.gap = 0.05}, options)->is_grave);
  EXPECT_TRUE(fault_of(0, {.gap = 0.05 * just_above}, options)->is_grave);
  EXPECT_FALSE(fault_of(0, {.penetration = 0.05}, options)->is_grave);
  EXPECT_TRUE(fault_of(0, {.penetration = 0.05 * just_above}, options)->is_grave);
}

TEST(Faults, MayStayWhereTheyAreSmallAndOneOfTwoHundred) {
  const SettleOptions options;
  const Fault small{0, "overlaps", false}, grave{0, "overlaps", true};
  EXPECT_TRUE(may_pass({}, 1, options));
  EXPECT_TRUE(may_pass({small}, 200, options));
  EXPECT_FALSE(may_pass({small}, 199, options));
  EXPECT_FALSE(may_pass({small, small}, 399, options));
  EXPECT_FALSE(may_pass({grave}, 100000, options));
}

}  // namespace
}  // namespace pomona
