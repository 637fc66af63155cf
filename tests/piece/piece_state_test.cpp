#include "generator/piece/piece_state.h"

#include <string>

#include <gtest/gtest.h>

namespace pomona {
namespace {

std::string by(const std::vector<std::string>& knives) { return std::string(name_of(state_by(knives))); }

TEST(PieceState, IsWhatACookWouldSay) {
  EXPECT_EQ(by({}), "whole");
  EXPECT_EQ(by({"half"}), "half");
  EXPECT_EQ(by({"half", "across"}), "quarter");
  EXPECT_EQ(by({"wedges:6"}), "wedge");
  EXPECT_EQ(by({"half", "slices:4mm"}), "slice");
  EXPECT_EQ(by({"crinkle:8mm"}), "slice");
  EXPECT_EQ(by({"slices:8mm", "dice:8mm"}), "dice");
  EXPECT_EQ(by({"sticks:6mm"}), "stick");
  EXPECT_EQ(by({"plane:0,1,0,1cm"}), "piece");
  EXPECT_EQ(by({"peel:1mm"}), "whole");
  EXPECT_EQ(by({"peel:1mm", "wedges:4"}), "wedge");
}

/// Two triangles of the areas of a piece's skin and of its cut faces.
Solid piece_with(float skin, float cut) {
  Solid solid;
  solid.mesh.position = {{0, 0, 0}, {skin, 0, 0}, {0, 1, 0}, {0, 0, 1}, {cut, 0, 1}, {0, 1, 1}};
  solid.mesh.part = {0, 0, 0, 0, 0, 0};
  solid.mesh.triangle = {{0, 1, 2}, {3, 4, 5}};
  solid.mesh.cut_face = {-1, 0};
  solid.origin.knives = {"peel:2mm", "wedges:4"};
  return solid;
}

TEST(PieceState, TellsPeelFromWhatIsPeeled) {
  const PieceState peel = state_of(piece_with(1, 1.2f)), peeled = state_of(piece_with(0.01f, 1));
  EXPECT_EQ(peel.state, CutState::peel);
  EXPECT_FALSE(peel.peeled);
  EXPECT_EQ(peeled.state, CutState::wedge);
  EXPECT_TRUE(peeled.peeled);
}

}  // namespace
}  // namespace pomona
