#include "generator/diffusion/harmonic/quad.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(Quad, KeepsItsLanesApart) {
  const Quad a{1, 2, 3, 4}, b{0.1f, 0.2f, 0.3f, 0.7f};
  const Quad c = 3.0f * a + b;
  for (int k = 0; k < 4; ++k) EXPECT_EQ(c[k], 3.0f * a[k] + b[k]);
  EXPECT_EQ(sizeof(Quad), 16u);
}

}  // namespace
}  // namespace pomona
