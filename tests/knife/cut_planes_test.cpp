// The planes of several knives: which coincide, which belong to one blade, and which points lie on which.
#include "generator/knife/cut_planes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"

namespace pomona {
namespace {

const Box<double> box{{-0.05, 0, -0.04}, {0.05, 0.08, 0.04}};

CutPlanes planes_for(std::initializer_list<const char*> texts) {
  std::vector<Knife> knives;
  for (const char* text : texts) knives.push_back(parse_knife(text));
  return cut_planes(knives, box);
}

Knife stroke(std::vector<glm::dvec2> points) { return {PlaneCut(StrokeKnife{std::move(points)}), "stroke"}; }

TEST(CutPlanes, KnowWhichPlanesOfEarlierKnivesTheyRepeat) {
  const CutPlanes planes = planes_for({"half", "across", "wedges:4", "plane:0,-1,0,-4cm"});
  ASSERT_EQ(planes.count(), 5);
  EXPECT_EQ(planes[0].same_as, 0);
  EXPECT_EQ(planes[1].same_as, 1);
  EXPECT_EQ(planes[2].same_as, 0) << "the first of four wedges is a half";
  EXPECT_TRUE(planes[2].turned);
  EXPECT_EQ(planes[3].same_as, 3);
  EXPECT_EQ(planes[4].same_as, 1);
  EXPECT_TRUE(planes[4].turned);
  EXPECT_TRUE(planes[0].through_axis && planes[3].through_axis);
  EXPECT_FALSE(planes[1].through_axis);
}

TEST(CutPlanes, OfAStrokeAreOneBlade) {
  const std::vector<Knife> knives{parse_knife("half"), stroke({{-0.05, 0.02}, {0, 0.03}, {0.05, 0.02}}),
                                  parse_knife("across"), parse_knife("crinkle:30mm")};
  const CutPlanes planes = cut_planes(knives, box);
  ASSERT_EQ(planes.blades.size(), 3 + planes.knives[3].strokes.size());
  EXPECT_EQ(planes.blades[1].first, 1);
  EXPECT_EQ(planes.blades[1].count, 2);
  EXPECT_EQ(planes.blades[2].first, 3);
  EXPECT_FALSE(planes.blades[2].stroke);
  int next = 0;
  for (std::size_t b = 0; b < planes.blades.size(); ++b) {
    EXPECT_EQ(planes.blades[b].first, next);
    for (int i = 0; i < planes.blades[b].count; ++i) EXPECT_EQ(planes[next++].blade, static_cast<int>(b));
  }
  EXPECT_EQ(next, planes.count());

  // A facet ends where the stroke bends; the first and the last facet have no end.
  EXPECT_TRUE(planes.is_in_facet(1, {-9, 0, 0}));
  EXPECT_FALSE(planes.is_in_facet(1, {0.01, 0.032, 0}));
  EXPECT_TRUE(planes.is_in_facet(0, {1, 2, 3})) << "a plane has no facet";
  EXPECT_EQ(planes.facet(0), nullptr);
}

TEST(CutPlanes, StrokesAlongOtherKnivesAreRefused) {
  const std::vector<Knife> knives{parse_knife("across"), stroke({{-0.05, 0.04}, {0.01, 0.04}, {0.05, 0.02}})};
  try {
    cut_planes(knives, box);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"stroke\" runs along knife \"across\""));
  }
}

TEST(CutPlanes, MakeNoMoreThanTenThousandCells) {
  EXPECT_NO_THROW(planes_for({"dice:17", "half"}));
  EXPECT_THROW(planes_for({"dice:18", "half"}), Error);
}

TEST(CutPlanes, AClosedKnifeHasNoneAndTwoCells) {
  const CutPlanes planes = planes_for({"ball:2cm"});
  EXPECT_EQ(planes.count(), 0);
  ASSERT_EQ(planes.knives.size(), 1u);
  EXPECT_EQ(planes.knives[0].cell_count(), 2);
  EXPECT_EQ(planes.knives[0].cell({}), 0);
}

TEST(CutPlanes, FixCoordinatesToTheBit) {
  const CutPlanes planes = planes_for({"across", "wedges:6"});
  const glm::dvec3 near(1e-17, 0.04 + 1e-17, -1e-17);
  EXPECT_EQ(snapped_to_planes(near, {0}, planes), glm::dvec3(1e-17, planes[0].plane.offset, -1e-17));
  EXPECT_EQ(snapped_to_planes(near, {1, 2}, planes), glm::dvec3(0, near.y, 0));
}

TEST(PlaneSets, WithTwoPlanesThroughTheAxisHoldAllOfThem) {
  const CutPlanes planes = planes_for({"wedges:6", "across"});
  PlaneSets sets(planes);
  const std::uint32_t one = sets.with(0, 1);
  EXPECT_THAT(sets.planes_in(one), testing::ElementsAre(1));
  EXPECT_FALSE(sets.on_axis(one));
  const std::uint32_t two = sets.with(one, 2);
  EXPECT_THAT(sets.planes_in(two), testing::ElementsAre(0, 1, 2));
  EXPECT_TRUE(sets.on_axis(two));
  EXPECT_TRUE(sets.has(two, 0));
}

TEST(PlaneSets, HaveOneNumberEach) {
  const CutPlanes planes = planes_for({"slices:4", "half"});
  PlaneSets sets(planes);
  const std::uint32_t ab = sets.with(sets.with(0, 0), 3), ba = sets.with(sets.with(0, 3), 0);
  EXPECT_EQ(ab, ba);
  EXPECT_EQ(sets.with(ab, 3), ab);
  EXPECT_EQ(sets.common(ab, sets.with(0, 3)), sets.with(0, 3));
  EXPECT_EQ(sets.common(sets.with(0, 1), sets.with(0, 2)), 0u);
}

}  // namespace
}  // namespace pomona
