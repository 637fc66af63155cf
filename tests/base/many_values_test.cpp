#include "generator/base/many_values.h"

#include <bit>
#include <cmath>

#include <gmock/gmock.h>
#include <glm/common.hpp>

#include "generator/base/color.h"
#include "generator/base/gradient_noise.h"
#include "generator/base/random.h"
#include "generator/base/reproducible.h"

namespace pomona {
namespace {

const RandomStream stream({11, 0}, "many_values_test");

/// The widths that this processor has.
std::vector<VectorWidth> widths() {
  std::vector<VectorWidth> all;
  for (const VectorWidth width : {VectorWidth::plain, VectorWidth::four, VectorWidth::eight})
    if (width <= widest_vectors()) all.push_back(width);
  return all;
}

/// Numbers of all sizes and signs, and zeros; not a whole number of vectors.
std::vector<double> some_numbers(std::uint64_t seed) {
  std::vector<double> numbers{0.0, -0.0, 1.0, -1.0, 1e-300, -1e300};
  for (std::uint64_t i = 0; i < 4001; ++i)
    numbers.push_back(
        std::ldexp(stream.uniform(2 * i + seed) - 0.5, static_cast<int>(40 * stream.uniform(2 * i + 1 + seed)) - 30));
  return numbers;
}

void expect_bits(double one, double of_many) {
  ASSERT_EQ(std::bit_cast<std::uint64_t>(one), std::bit_cast<std::uint64_t>(of_many)) << one << " " << of_many;
}

TEST(ManyValues, HaveTheBitsOfOneByOneInVectorsOfEveryWidth) {
  const std::vector<double> x = some_numbers(0), y = some_numbers(100'000);
  for (const VectorWidth width : widths()) {
    const std::vector<double> powers = reproducible::exponentials(x, width), roots = reproducible::cube_roots(x, width),
                              azimuths = reproducible::azimuths(y, x, width);
    for (std::size_t i = 0; i < x.size(); ++i) {
      expect_bits(reproducible::exp(x[i]), powers[i]);
      expect_bits(reproducible::cbrt(x[i]), roots[i]);
      expect_bits(reproducible::atan2(y[i], x[i]), azimuths[i]);
    }
  }
}

/// Places in lattices with and without a period, some of them at lattice points.
NoisePlaces some_places(double size) {
  NoisePlaces places;
  for (std::uint64_t i = 0; i < 4003; ++i) {
    glm::dvec3 point(stream.uniform(3 * i), stream.uniform(3 * i + 1), stream.uniform(3 * i + 2));
    point = (point - 0.5) * size;
    if (i % 16 == 0) point = glm::round(point);
    places.add(point, static_cast<std::uint32_t>(i % 5), i % 3 == 0 ? 15 : ~0);
  }
  return places;
}

TEST(ManyValues, NoiseHasTheBitsOfOneByOneInVectorsOfEveryWidthAndBeyondTheLattice) {
  for (const double size : {20.0, 1e6, 1e11}) {
    const NoisePlaces places = some_places(size);
    for (const VectorWidth width : widths()) {
      const std::vector<double> noise = gradient_noise(places, width);
      for (std::size_t i = 0; i < noise.size(); ++i) {
        const glm::dvec3 point(places.x[i], places.y[i], places.z[i]);
        const bool has_period = places.mask[i] != ~0;
        expect_bits(has_period ? gradient_noise_around(point, places.seed[i], places.mask[i] + 1)
                               : gradient_noise(point, places.seed[i]),
                    noise[i]);
      }
    }
  }
}

TEST(ManyValues, OklabHasTheBitsOfOneByOne) {
  std::vector<Color> colors{Color(0), Color(1)};
  for (std::uint64_t i = 0; i < 999; ++i)
    colors.emplace_back(stream.uniform(3 * i), stream.uniform(3 * i + 1), stream.uniform(3 * i + 2));
  const std::vector<glm::vec3> lab = to_oklab(colors);
  for (std::size_t i = 0; i < colors.size(); ++i) EXPECT_EQ(to_oklab(colors[i]), lab[i]);
}

}  // namespace
}  // namespace pomona
