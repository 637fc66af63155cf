#include "generator/cut/piece_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using testing::ElementsAre;

CutPiece part_of(const DiffusionSurfaces& surfaces) {
  CutPiece part;
  part.position = surfaces.position;
  part.triangle = surfaces.triangle;
  part.volume = shapes::signed_volume(surfaces);
  return part;
}

CutPiece box_of(double low, double high) { return part_of(shapes::box(glm::dvec3(low), glm::dvec3(high), 1)); }

/// The wall of a hollow: it faces inwards.
CutPiece hollow_of(double low, double high) {
  return part_of(shapes::turned_inside_out(shapes::box(glm::dvec3(low), glm::dvec3(high), 1)));
}

TEST(PieceGroups, KeepApartWhatIsApart) {
  const std::vector<CutPiece> parts{box_of(0, 1), box_of(2, 3), box_of(4, 5)};
  EXPECT_THAT(piece_groups(parts, {0, 0, 0}, {}), ElementsAre(0, 1, 2));
}

TEST(PieceGroups, GiveAHollowToWhatIsAroundIt) {
  const std::vector<CutPiece> parts{hollow_of(0.4, 0.6), box_of(5, 9), box_of(0, 1), hollow_of(6, 7)};
  EXPECT_THAT(piece_groups(parts, {0, 0, 0, 0}, {}), ElementsAre(0, 1, 0, 1));
}

TEST(PieceGroups, LeaveWhatLiesInAHollowByItself) {
  const std::vector<CutPiece> parts{box_of(0, 10), hollow_of(1, 9), box_of(3, 6), hollow_of(4, 5)};
  EXPECT_THAT(piece_groups(parts, {0, 0, 0, 0}, {}), ElementsAre(0, 0, 2, 2));
}

/// Walls without the part around them contain nothing; nor does a part that is a box in one place and such a wall in
/// another.
TEST(PieceGroups, TakeNothingIntoWhatIsInsideOut) {
  EXPECT_THAT(piece_groups({hollow_of(0, 10), box_of(3, 4)}, {0, 0}, {}), ElementsAre(0, 1));
  const CutPiece both = part_of(joined(shapes::box(glm::dvec3(20), glm::dvec3(40), 1),
                                       shapes::turned_inside_out(shapes::box(glm::dvec3(0), glm::dvec3(10), 1))));
  ASSERT_GT(both.volume, 0);
  EXPECT_THAT(piece_groups({both, hollow_of(4, 5)}, {0, 0}, {}), ElementsAre(0, 1));
}

TEST(PieceGroups, BringTogetherWhatOverlaps) {
  const std::vector<CutPiece> parts{box_of(0, 1), box_of(3, 4), box_of(0.5, 2), box_of(1.7, 3.2)};
  EXPECT_THAT(piece_groups(parts, {0, 0, 0, 0}, {}), ElementsAre(0, 0, 0, 0));
}

TEST(PieceGroups, KeepCellsApart) {
  const std::vector<CutPiece> parts{box_of(0, 1), box_of(0.5, 2), hollow_of(0.2, 0.4), box_of(0.1, 0.9)};
  EXPECT_THAT(piece_groups(parts, {0, 1, 0, 2}, {}), ElementsAre(0, 1, 0, 3));
}

}  // namespace
}  // namespace pomona
