// Numbers of POV-Ray's meshes: integers times a power of ten.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "generator/base/number_text.h"
#include "render/export/pov_text.h"

namespace pomona::pov {
namespace {

TEST(PovText, ExponentsBringSizesBetweenTwoPowersOfTen) {
  // From 1 to 10^22 powers of ten are exact, and so are their quotients.
  for (int digits = 1; digits <= 6; ++digits) {
    for (int exponent = 1; exponent <= 15; ++exponent) {
      const double low = power_of_ten(digits + exponent);
      EXPECT_EQ(exponent_for(low, digits), exponent) << low;
      EXPECT_EQ(exponent_for(std::nextafter(low, 0.0), digits), exponent - 1) << "just below " << low;
      EXPECT_EQ(exponent_for(5 * low, digits), exponent) << 5 * low;
    }
  }
}

TEST(PovText, QuotesAndCommentsHoldAnyText) {
  EXPECT_EQ(quoted("a \"b\" \\c"), "\"a \\\"b\\\" \\\\c\"");
  EXPECT_EQ(commentable("a\nb\tc d"), "a b c d");
}

TEST(PovText, NumbersReadBackAsTheyWere) {
  for (const double number : {0.1, 1.0 / 3, -2.5e-9, 123456789.0, 0.0})
    EXPECT_EQ(std::stod(number_text(number)), number);
  EXPECT_EQ(vector_text({1, 0.5, -2}), "<1, 0.5, -2>");
}

}  // namespace
}  // namespace pomona::pov
