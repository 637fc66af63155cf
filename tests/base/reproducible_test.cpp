#include "generator/base/reproducible.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "generator/base/random.h"
#include "generator/base/units.h"

namespace pomona {
namespace {

/// Results are within two units in the last place of the C library's, which differ from processor to processor.
void expect_near(double ours, double theirs) {
  const double unit = std::max(std::fabs(theirs), 1e-300) * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(ours, theirs, 2 * unit);
}

TEST(Reproducible, agrees_with_the_c_library) {
  const RandomStream random({3, 0}, "reproducible");
  for (std::uint64_t n = 0; n < 2000; ++n) {
    const double x = 20 * random.uniform(n) - 10, positive = 10 * random.uniform(n + 5000) + 1e-9;
    expect_near(reproducible::sin(x), std::sin(x));
    expect_near(reproducible::cos(x), std::cos(x));
    expect_near(reproducible::atan2(x, positive - 5), std::atan2(x, positive - 5));
    expect_near(reproducible::acos(x / 10), std::acos(x / 10));
    expect_near(reproducible::exp(x), std::exp(x));
    expect_near(reproducible::log(positive), std::log(positive));
    expect_near(reproducible::pow(positive, x), std::pow(positive, x));
    expect_near(reproducible::cbrt(x), std::cbrt(x));
  }
}

TEST(Reproducible, four_cube_roots_have_the_bits_of_one) {
  for (int i = 0; i < 4000; ++i) {
    const double x = (i - 2000) * 0.00137;
    const auto found = reproducible::cbrt({x, 1000 * x, x * x, x / 1e9});
    const std::array<double, 4> one{reproducible::cbrt(x), reproducible::cbrt(1000 * x), reproducible::cbrt(x * x),
                                    reproducible::cbrt(x / 1e9)};
    EXPECT_EQ(found, one) << x;
  }
}

TEST(Reproducible, the_bits_are_frozen) {
  // A sum over many arguments: one changed bit anywhere changes it. The same on every machine and compiler.
  std::uint64_t hash = 1469598103934665603u;
  for (int i = 1; i < 1000; ++i) {
    const double x = i * 0.01;
    for (const double y :
         {reproducible::sin(x), reproducible::cos(x), reproducible::atan2(x, 3.0), reproducible::acos(i / 1000.0),
          reproducible::exp(x), reproducible::log(x), reproducible::pow(x, 2.4), reproducible::cbrt(x)}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(y)) * 1099511628211u;
    }
  }
  EXPECT_EQ(hash, 18283384701645258301u);
}

}  // namespace
}  // namespace pomona
