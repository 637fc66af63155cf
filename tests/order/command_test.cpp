// The commands that make pieces again: tests/cli/remake_test.py runs them.
#include <gtest/gtest.h>

#include "generator/order/option_table.h"
#include "generator/order/ordered_fruit.h"

namespace pomona {
namespace {

TEST(Command, TheDrawingNeedsNoMoreThanItsName) {
  const PieceOrigin whole{.source = "tomato", .growing = {.as_drawn = true}, .number = 1, .pieces = 1};
  EXPECT_EQ(command_for(whole, "x.glb"), "pomona grow tomato -o x.glb");
}

TEST(Command, SaysAllThatIsNotAsUsual) {
  const PieceOrigin piece{
      .source = "my fruit.toml",
      .key = {.seed = 0, .index = 7},
      .growing =
          {.variation = 0.5, .curves_only = true, .folds = 4, .detail = 0.1, .ripeness = 1.0 / 3, .browning = 0.25},
      .knives = {"half", "stroke:a.svg#wave"},
      .coarse = true,
      .number = 2,
      .pieces = 9};
  EXPECT_EQ(command_for(piece, "x.glb", " --style plain"),
            "pomona cut 'my fruit.toml' --seed 0 --index 7 --variation 0.5 --curves-only --folds 4 --ripeness "
            "0.3333333333333333 --detail 0.1 --knife half --knife 'stroke:a.svg#wave' --browning 0.25 --faces coarse "
            "--piece 2 --style plain -o x.glb");
}

TEST(Command, KeepsLargeSeedsWhole) {
  const PieceOrigin piece{.source = "kiwi", .key = {.seed = 18446744073709551615u}, .number = 1, .pieces = 1};
  EXPECT_EQ(command_for(piece, "x.glb"), "pomona grow kiwi --seed 18446744073709551615 -o x.glb");
}

TEST(Command, NamesTheStyleAsSeenFromWhereItIsTyped) {
  Order order;
  order.color.style = "sets/looks/mine.toml";
  EXPECT_EQ(piece_words(order), " --style sets/looks/mine.toml");
  order.color.style_word = "looks/mine.toml";
  EXPECT_EQ(piece_words(order), " --style looks/mine.toml");
}

/// There each material is a draw call.
TEST(Order, PiecesHaveOneMaterialForEngines) {
  Order order;
  EXPECT_EQ(atlas_of(order.mesh), AtlasOf::none);
  for (const Engine engine : {Engine::godot, Engine::unreal, Engine::unity}) {
    order.mesh.engine = engine;
    EXPECT_EQ(atlas_of(order.mesh), AtlasOf::piece);
  }
  EXPECT_EQ(piece_words(order), " --engine unity") << "the same for the one who types it";
  order.mesh.atlas = AtlasOf::none;
  EXPECT_EQ(atlas_of(order.mesh), AtlasOf::none);
  EXPECT_EQ(piece_words(order), " --atlas none --engine unity");
  order.mesh = {.engine = Engine::blender};
  EXPECT_EQ(atlas_of(order.mesh), AtlasOf::none);
}

TEST(Command, OfNobodyKnowsWhatIsNoCommand) {
  EXPECT_EQ(command_for({}, "x.glb"), "");
  EXPECT_EQ(command_for({.source = "kiwi"}, "x.glb"), "") << "which piece?";
}

}  // namespace
}  // namespace pomona
