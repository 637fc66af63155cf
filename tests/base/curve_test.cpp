#include "generator/base/curve.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

const Curve square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, true};
const Curve stroke{{{0, 0}, {3, 4}, {3, 10}}, false};

TEST(Curve, lengths_and_areas_are_exact) {
  EXPECT_EQ(length(square), 8);
  EXPECT_EQ(length(stroke), 11);
  EXPECT_EQ(signed_area(square), 4);
  EXPECT_EQ(signed_area(Curve{{{0, 0}, {0, 2}, {2, 2}, {2, 0}}, true}), -4);
  EXPECT_EQ(length(Curve{}), 0);
}

TEST(Curve, resampling_is_even_and_keeps_the_ends) {
  const Curve open = resampled(stroke, 12);
  ASSERT_EQ(open.points.size(), 12u);
  EXPECT_EQ(open.points.front(), stroke.points.front());
  EXPECT_EQ(open.points.back(), stroke.points.back());
  EXPECT_NEAR(glm::distance(open.points[1], open.points[2]), 1, 1e-12);

  const Curve closed = resampled(square, 16);
  ASSERT_EQ(closed.points.size(), 16u);
  EXPECT_EQ(closed.points[0], square.points[0]);
  EXPECT_EQ(closed.points[4], square.points[1]);
  EXPECT_NEAR(length(closed), 8, 1e-12);
}

TEST(Curve, points_by_share_of_the_length) {
  EXPECT_EQ(point_at(stroke, 0), glm::dvec2(0, 0));
  EXPECT_EQ(point_at(stroke, 1), glm::dvec2(3, 10));
  EXPECT_EQ(point_at(square, 0.5), glm::dvec2(2, 2));
  EXPECT_EQ(point_at(square, 1.25), point_at(square, 0.25));
}

TEST(Curve, turning_keeps_the_first_point) {
  const Curve turned = counter_clockwise(Curve{{{0, 0}, {0, 2}, {2, 2}, {2, 0}}, true});
  EXPECT_EQ(turned.points, square.points);
  EXPECT_EQ(counter_clockwise(square).points, square.points);
}

TEST(Curve, crossings_are_found) {
  EXPECT_TRUE(is_simple(square));
  EXPECT_TRUE(is_simple(stroke));
  EXPECT_FALSE(is_simple(Curve{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, true}));
  EXPECT_FALSE(is_simple(Curve{{{0, 0}, {4, 0}, {4, 2}, {2, 0}}, false}));         // ends on an edge
  EXPECT_FALSE(is_simple(Curve{{{0, 0}, {4, 0}, {4, 1}, {2, 0}, {0, 1}}, true}));  // a corner touches an edge
}

TEST(Curve, an_edge_that_turns_back_on_itself_is_a_crossing) {
  EXPECT_FALSE(is_simple(Curve{{{0, 0}, {4, 0}, {2, 0}}, false}));
  EXPECT_FALSE(is_simple(Curve{{{0, 0}, {4, 0}, {2, 0}, {2, 3}}, true}));
}

TEST(Curve, hostile_zigzags_do_not_hang) {
  // 65 536 long edges that all overlap in x: comparing all pairs would take minutes.
  Curve zigzag;
  for (int i = 0; i < 65536; ++i) zigzag.points.emplace_back(i % 2, i * 1e-3);
  EXPECT_FALSE(is_simple(zigzag));
}

TEST(Curve, winding_tells_inside_from_outside) {
  EXPECT_TRUE(encloses(square, {1, 1}));
  EXPECT_FALSE(encloses(square, {3, 1}));
  EXPECT_FALSE(encloses(square, {1, -1}));
  EXPECT_TRUE(encloses(Curve{{{0, 0}, {0, 2}, {2, 2}, {2, 0}}, true}, {1, 1}));
}

}  // namespace
}  // namespace pomona
