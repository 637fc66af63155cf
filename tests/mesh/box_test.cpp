#include "generator/mesh/box.h"

#include <gtest/gtest.h>

#include "tests/mesh/random_points.h"

namespace pomona {
namespace {

template <typename T>
class Boxes : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(Boxes, Precisions);

TYPED_TEST(Boxes, AreTheLeastAroundWhatWasPutIn) {
  using Point = typename Box<TypeParam>::Point;
  std::vector<Point> points;
  for (const glm::dvec3& p : random_points(50, 3)) points.push_back(Point(p));
  const Box<TypeParam> box = box_around(points);
  for (int axis = 0; axis < 3; ++axis) {
    bool low = false, high = false;
    for (const Point& p : points) {
      EXPECT_LE(box.low[axis], p[axis]);
      EXPECT_GE(box.high[axis], p[axis]);
      low = low || box.low[axis] == p[axis];
      high = high || box.high[axis] == p[axis];
    }
    EXPECT_TRUE(low && high) << "each face has a point on it";
  }
  EXPECT_EQ(box_around(points[0], points[1], points[2]).low,
            box_around(std::vector<Point>(points.begin(), points.begin() + 3)).low);
}

TYPED_TEST(Boxes, AreEmptyUntilSomethingIsPutIn) {
  const Box<TypeParam> unit{typename Box<TypeParam>::Point(0), typename Box<TypeParam>::Point(1)};
  const Box<TypeParam> empty;
  EXPECT_FALSE(empty.meets(unit));
  EXPECT_FALSE(unit.meets(empty));
  EXPECT_FALSE(empty.meets(empty));
  Box<TypeParam> both = unit;
  both.add(empty);
  EXPECT_EQ(both.low, unit.low);
  EXPECT_EQ(both.high, unit.high);
}

TYPED_TEST(Boxes, MeetWhatTheyTouchAndNothingBeyond) {
  using Point = typename Box<TypeParam>::Point;
  const Box<TypeParam> unit{Point(0), Point(1)};
  for (int axis = 0; axis < 3; ++axis) {
    for (const TypeParam way : {TypeParam(-1), TypeParam(1)}) {
      Point by(0);
      by[axis] = way;
      EXPECT_TRUE(unit.meets(unit.moved(by))) << "face to face";
      EXPECT_EQ(squared_distance(unit, unit.moved(by)), 0);
      by[axis] *= TypeParam(1.25);
      EXPECT_FALSE(unit.meets(unit.moved(by)));
      EXPECT_EQ(squared_distance(unit, unit.moved(by)), TypeParam(0.0625));
    }
  }
}

TYPED_TEST(Boxes, AreAsFarFromAPointAsTheirNearestPlace) {
  using Point = typename Box<TypeParam>::Point;
  const Box<TypeParam> box{Point(-1, 0, 2), Point(1, 0.5, 5)};
  for (const glm::dvec3& at : random_points(200, 6)) {
    const Point p(at), away = p - glm::clamp(p, box.low, box.high);
    EXPECT_EQ(squared_distance(box, p), glm::dot(away, away));
    EXPECT_EQ(squared_distance(box, p), squared_distance(box, Box<TypeParam>{p, p}));
  }
}

TEST(Box, KnowsItsSizeAndItsMiddle) {
  const Box<double> box{{1, 2, 3}, {2, 6, 4}};
  EXPECT_EQ(box.size(), glm::dvec3(1, 4, 1));
  EXPECT_EQ(box.center(), glm::dvec3(1.5, 4, 3.5));
  EXPECT_EQ(longest_axis(box.size()), 1);
  EXPECT_EQ(longest_axis(glm::dvec3(2, 2, 2)), 0) << "of equals the first";
  EXPECT_EQ(longest_axis(glm::dvec3(1, 2, 2)), 1);
  EXPECT_EQ(longest_axis(glm::dvec3(1, 1, 2)), 2);
}

}  // namespace
}  // namespace pomona
