#include "generator/piece/piece_origin.h"

#include <gtest/gtest.h>

#include "generator/knife/parse_knife.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

TEST(PieceOrigin, TellsItsKnives) {
  EXPECT_EQ(knives_text({.knives = {"half", "stroke:a.svg#wave"}}), "half stroke:a.svg#wave");
}

TEST(PieceOrigin, PathsFromTheRootAreOfNoUseElsewhere) {
  EXPECT_EQ(source_word("tomato"), "tomato");
  EXPECT_EQ(source_word("fruit/plum.toml"), "fruit/plum.toml");
  EXPECT_EQ(source_word("/home/me/plum.toml"), "plum.toml");
}

/// Pieces keep their numbers in the whole cut if only a few or one of them are wanted.
TEST(PieceOrigin, NumbersAreThoseOfTheWholeCut) {
  const GrownFruit grown{shapes::seeded_fruit(), {}, shapes::seeded_fruit()};
  Template fruit;
  fruit.parts = grown.sheets.part_names;
  const std::vector<Knife> knives{parse_knife("half"), parse_knife("slices:3")};
  SliceTask task{.grown = grown, .variant = fruit, .knives = knives};
  const std::vector<Solid> all = slice(task, nullptr).pieces;
  ASSERT_EQ(all.size(), 6u);
  task.choice = PieceChoice{.take = 2};
  const std::vector<Solid> largest = slice(task, nullptr).pieces;
  ASSERT_EQ(largest.size(), 2u);
  for (const Solid& piece : largest) {
    EXPECT_EQ(piece.origin.pieces, 6);
    EXPECT_EQ(piece.origin.knives, (std::vector<std::string>{"half", "slices:3"}));
    const auto number = static_cast<std::size_t>(piece.origin.number);
    EXPECT_EQ(piece.mesh.position, all[number - 1].mesh.position);

    SliceTask again = task;
    again.choice = PieceChoice{.only = piece.origin.number};
    const std::vector<Solid> one = slice(again, nullptr).pieces;
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].mesh.position, piece.mesh.position);
    EXPECT_EQ(one[0].origin.number, piece.origin.number);
  }
  task.choice = PieceChoice{.only = 7};
  EXPECT_TRUE(slice(task, nullptr).pieces.empty());
}

/// A cut that no command of the program makes has no command.
TEST(PieceOrigin, OtherCutFacesThanTheProgramsHaveNoSource) {
  const GrownFruit grown{shapes::seeded_fruit(), {}, shapes::seeded_fruit()};
  const Template fruit;
  const std::vector<Knife> knives{parse_knife("half")};
  const SliceTask task{.grown = grown, .variant = fruit, .knives = knives, .origin = {.source = "seeded"}};
  EXPECT_EQ(slice(task, nullptr).pieces[0].origin.source, "seeded");
  EXPECT_TRUE(slice(task, nullptr, {.cut = coarse_cut}).pieces[0].origin.coarse);
  EXPECT_EQ(slice(task, nullptr, {.cut = {.coarsest = 0.2}}).pieces[0].origin.source, "");
}

}  // namespace
}  // namespace pomona
