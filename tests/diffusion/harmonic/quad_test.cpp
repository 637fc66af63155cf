#include "generator/diffusion/harmonic/quad.h"

#include <utility>

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(Quad, KeepsItsLanesApart) {
  const Quad a{1, 2, 3, 4}, b{0.1f, 0.2f, 0.3f, 0.7f};
  const Quad c = 3.0f * a + b;
  for (int k = 0; k < 4; ++k) EXPECT_EQ(c[k], 3.0f * a[k] + b[k]);
  EXPECT_EQ(sizeof(Quad), 16u);
}

TEST(RawArray, HoldsWhatWasWrittenAndGoesWhereItIsMoved) {
  RawArray<int> first(3);
  for (int i = 0; i < 3; ++i) first[static_cast<std::size_t>(i)] = 10 * i;
  EXPECT_EQ(first.bytes(), 3 * sizeof(int));
  const RawArray<int> second = std::move(first);
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[2], 20);
  EXPECT_EQ(second.data() + 1, &second[1]);
  EXPECT_EQ(RawArray<int>().size(), 0u);
}

}  // namespace
}  // namespace pomona
