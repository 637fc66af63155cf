// Loose bits stay with the piece on which they lie.
#include "generator/cut/stray_bits.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"
#include "generator/cut/cut.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/disjoint_sets.h"
#include "tests/cut/cut_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

constexpr double side = 0.06, bit_side = 0.004;

/// A box of 6 cm and, `gap` metres above it on the front half, a bit of 4 mm, 1/3375 of its volume.
DiffusionSurfaces box_with_bit(double gap, double size = bit_side) {
  return joined(
      shapes::box(glm::dvec3(-side / 2), glm::dvec3(side / 2), 8, shapes::skin_paint()),
      shapes::box({0, side / 2 + gap, 0.01}, {size, side / 2 + gap + size, 0.01 + size}, 2, shapes::skin_paint()));
}

Cut halves(const DiffusionSurfaces& fruit) { return cut(fruit, std::vector{parse_knife("half")}); }

TEST(StrayBits, StayWithThePieceTheyLieOn) {
  const Cut result = halves(box_with_bit(0.0005));
  const double half = side * side * side / 2, bit = bit_side * bit_side * bit_side;
  shapes::expect_whole(result, 2 * half + bit);
  ASSERT_EQ(result.pieces.size(), 2u) << "a half is one of two pieces";
  const auto [less, more] = std::minmax(result.pieces[0].volume, result.pieces[1].volume);
  EXPECT_NEAR(less, half, 1e-9);
  EXPECT_NEAR(more, half + bit, 1e-9);
}

TEST(StrayBits, ArePiecesWhereNothingIsNear) { EXPECT_EQ(halves(box_with_bit(0.01)).pieces.size(), 3u); }

TEST(StrayBits, AreNoLargerThanAThousandth) {
  EXPECT_EQ(halves(box_with_bit(0.0005, 0.0058)).pieces.size(), 2u);  // the share is 0.9 of a thousandth
  EXPECT_EQ(halves(box_with_bit(0.0005, 0.0062)).pieces.size(), 3u);  // 1.1
}

TEST(StrayBits, StayOnTheirSideOfTheKnife) {
  // The plane runs through the bit: either half of it stays with its half of the box.
  const DiffusionSurfaces fruit =
      joined(shapes::box(glm::dvec3(-side / 2), glm::dvec3(side / 2), 8, shapes::skin_paint()),
             shapes::box({0, side / 2 + 0.0005, -0.001}, {0.004, side / 2 + 0.0045, 0.003}, 2, shapes::skin_paint()));
  const Cut result = halves(fruit);
  ASSERT_EQ(result.pieces.size(), 2u);
  const auto [less, more] = std::minmax(result.pieces[0].volume, result.pieces[1].volume);
  EXPECT_NEAR(more - less, 0.004 * 0.004 * 0.002, 1e-10);
}

// ---- Held parts ----

/// A box with a stack of plates on its front half, each `gap` metres above what is below, and each thicker than a bit.
DiffusionSurfaces box_with_plates(double gap, int count) {
  shapes::Paint leaf = shapes::skin_paint();
  leaf.name = "leaf";
  leaf.front_part = leaf.back_part = "leaf";
  DiffusionSurfaces all = shapes::box(glm::dvec3(-side / 2), glm::dvec3(side / 2), 8, shapes::skin_paint());
  for (int i = 0; i < count; ++i) {
    const double low = side / 2 + gap + i * (0.004 + gap);
    all = joined(all, shapes::box({-0.02, low, 0.005}, {0.02, low + 0.004, 0.025}, 8, leaf));
  }
  return all;
}

/// How many pieces the knife leaves where leaves are held.
std::size_t pieces_with_held(const DiffusionSurfaces& fruit, const std::string& knife = "half") {
  const auto leaf = std::find(fruit.part_names.begin(), fruit.part_names.end(), "leaf");
  const std::vector<int> held{static_cast<int>(leaf - fruit.part_names.begin())};
  const Cut result = cut(fruit, std::vector{parse_knife(knife)}, {.held_parts = held});
  for (const CutPiece& piece : result.pieces) EXPECT_TRUE(piece.closed);
  return result.pieces.size();
}

TEST(HeldParts, StayWithThePieceTheyLieAgainstThroughOthers) {
  EXPECT_EQ(halves(box_with_plates(0.001, 3)).pieces.size(), 5u) << "two halves and three plates";
  EXPECT_EQ(pieces_with_held(box_with_plates(0.001, 3)), 2u);
  EXPECT_EQ(pieces_with_held(box_with_plates(0.006, 3)), 5u) << "none lies against another";
}

/// The corners of large triangles lie far from those of a neighbour that touches them in their middle.
TEST(HeldParts, LieAgainstTheMiddleOfLargeTriangles) {
  shapes::Paint leaf = shapes::skin_paint();
  leaf.name = "leaf";
  leaf.front_part = leaf.back_part = "leaf";
  const DiffusionSurfaces fruit =
      joined(shapes::box(glm::dvec3(-side / 2), glm::dvec3(side / 2), 1, shapes::skin_paint()),
             shapes::box({-0.02, side / 2 + 0.001, 0.002}, {0.02, side / 2 + 0.007, 0.027}, 1, leaf));
  EXPECT_EQ(pieces_with_held(fruit), 2u);
}

TEST(HeldParts, AreOnePieceWhereNothingElseIsNear) {
  EXPECT_EQ(pieces_with_held(box_with_plates(0.001, 3), "plane:0,1,0,30.5mm"), 2u) << "the box, and all plates";
}

TEST(HeldParts, NeverJoinTwoPiecesThatAreNot) {
  // A plate between two boxes on one side of the knife goes to one of them.
  const auto box_at = [](double x) {
    return shapes::box({x, -0.03, 0.005}, {x + 0.04, 0.03, 0.045}, 8, shapes::skin_paint());
  };
  shapes::Paint leaf = shapes::skin_paint();
  leaf.front_part = leaf.back_part = "leaf";
  const DiffusionSurfaces fruit = joined(joined(box_at(-0.0425), box_at(0.0025)),
                                         shapes::box({-0.0015, -0.03, 0.005}, {0.0015, 0.03, 0.045}, 8, leaf));
  EXPECT_EQ(pieces_with_held(fruit), 2u);
}

/// Sets of cubes of which one lies within reach of another, by the distance of their boxes.
std::size_t sets_within(const std::vector<glm::dvec3>& low, double cube, double reach) {
  DisjointSets sets(low.size());
  for (std::uint32_t a = 0; a < low.size(); ++a) {
    for (std::uint32_t b = 0; b < a; ++b) {
      const glm::dvec3 gap = glm::max(glm::abs(low[a] - low[b]) - cube, glm::dvec3(0));
      if (glm::length(gap) < reach) sets.join(a, b);
    }
  }
  std::size_t count = 0;
  for (std::uint32_t a = 0; a < low.size(); ++a) count += sets.root(a) == a ? 1 : 0;
  return count;
}

TEST(HeldParts, AreOnePieceWithAllWithinReach) {
  // Cubes at a third of the places of a grid whose steps are a little longer or shorter than the reach, and askew.
  shapes::Paint leaf = shapes::skin_paint();
  leaf.name = "leaf";
  leaf.front_part = leaf.back_part = "leaf";
  constexpr double cube = 0.01;
  for (const double gap : {0.7, 0.95, 1.02}) {
    const RandomStream random({}, "tests/held cubes");
    const double reach = 0.08 * cube * std::cbrt(60.0), step = cube + gap * reach;
    std::vector<glm::dvec3> low;
    for (std::uint64_t n = 0; low.size() < 60; ++n) {
      if (random.below(n, 3) != 0) continue;
      const auto k = static_cast<double>(n);
      low.emplace_back(step * std::fmod(k, 6) + 1e-5 * k, step * std::fmod(std::floor(k / 6), 6),
                       step * std::floor(k / 36));
    }
    DiffusionSurfaces all = shapes::box(low[0], low[0] + cube, 1, leaf);
    for (std::size_t i = 1; i < low.size(); ++i) all = joined(all, shapes::box(low[i], low[i] + cube, 1, leaf));
    const std::size_t expected = sets_within(low, cube, reach);
    EXPECT_EQ(pieces_with_held(all, "plane:0,1,0,1m"), expected);
  }
}

}  // namespace
}  // namespace pomona
