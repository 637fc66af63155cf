// Noise on lattices: hashes of cells, and places between the cells' points.
#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/cell_noise.h"
#include "generator/base/gradient_noise.h"

namespace pomona {
namespace {

TEST(LatticeHash, NeighboursHaveNothingInCommon) {
  // Between neighbouring cells each bit of the hash differs about every other time.
  constexpr int cells = 4000;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 32> differs{};
    for (int i = 0; i < cells; ++i) {
      const std::array<std::int32_t, 3> at{i % 17 - 8, i / 17 % 19 - 9, i / 323 - 6};
      std::array<std::int32_t, 3> beside = at;
      ++beside[static_cast<std::size_t>(axis)];
      const std::uint32_t change =
          lattice_hash(at[0], at[1], at[2], 5) ^ lattice_hash(beside[0], beside[1], beside[2], 5);
      for (std::size_t bit = 0; bit < 32; ++bit) differs[bit] += (change >> bit & 1u) != 0 ? 1 : 0;
    }
    // The standard deviation of the numbers is 32.
    for (std::size_t bit = 0; bit < 32; ++bit) EXPECT_NEAR(differs[bit], cells / 2, 160) << "bit " << bit;
  }
}

/// Wellons' lowbias32, computed by hand. Another function would change every noise.
TEST(LatticeHash, IsTheOneThatFilesRestOn) {
  EXPECT_EQ(lattice_hash(0, 0, 0, 0), 0x0u);
  EXPECT_EQ(lattice_hash(1, 2, 3, 4), 0xa1bfec75u);
  EXPECT_EQ(lattice_hash(-5, 0, 7, 1), 0xb2c56018u);
}

TEST(CellPlace, BothPointsAreEquallyFarWhereCellsMeet) {
  const glm::dvec3 from(-3.1, 0.2, 1.7), way = glm::normalize(glm::dvec3(1, 0.31, -0.23));
  constexpr double step = 1e-4;
  CellPlace before = cell_place(from, 9);
  int borders = 0;
  for (int i = 1; i < 200000; ++i) {
    const CellPlace here = cell_place(from + i * step * way, 9);
    EXPECT_LE(here.nearest, here.second);
    EXPECT_NEAR(here.second, before.second, 1.001 * step) << "a distance changes no faster than one walks";
    if (here.hash != before.hash) {
      ++borders;
      EXPECT_LT(here.second - here.nearest, 2.001 * step);
    }
    before = here;
  }
  EXPECT_GT(borders, 20);
}

}  // namespace
}  // namespace pomona
