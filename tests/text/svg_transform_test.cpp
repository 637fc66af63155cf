#include "generator/text/svg_transform.h"

#include <clocale>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

void expect_moved(const char* transform, glm::dvec2 from, glm::dvec2 to) {
  SCOPED_TRACE(transform);
  const auto parsed = parse_svg_transform(transform);
  ASSERT_TRUE(parsed);
  EXPECT_LT(glm::distance((*parsed)(from), to), 1e-12);
}

TEST(SvgTransform, every_kind_moves_as_svg_says) {
  expect_moved("", {3, 4}, {3, 4});
  expect_moved("translate(10,20)", {3, 4}, {13, 24});
  expect_moved("translate(10)", {3, 4}, {13, 4});
  expect_moved("scale(2)", {3, 4}, {6, 8});
  expect_moved("scale(2 -1)", {3, 4}, {6, -4});
  expect_moved("rotate(90)", {3, 4}, {-4, 3});
  expect_moved("rotate(90 10 20)", {10, 21}, {9, 20});
  expect_moved("skewX(45)", {3, 4}, {7, 4});
  expect_moved("skewY(45)", {3, 4}, {3, 7});
  expect_moved("matrix(1 2 3 4 5 6)", {1, 10}, {1 + 30 + 5, 2 + 40 + 6});
}

TEST(SvgTransform, lists_apply_from_the_right) {
  expect_moved("translate(10 0) scale(2)", {3, 4}, {16, 8});
  expect_moved("scale(2),translate(10,0)", {3, 4}, {26, 8});
  expect_moved(" rotate( 90 ) translate(1,0)\n", {0, 0}, {0, 1});
  expect_moved("translate(1-2)scale(1e1,1E+1)", {1, 1}, {11, 8});
}

TEST(SvgTransform, anything_else_is_none) {
  for (const char* text :
       {"rotate", "rotate(", "rotate(a)", "rotate(1 2)", "matrix(1 2 3 4 5)", "turn(3)", "scale(nan)", "scale(inf)",
        "scale(1e300)", "translate(1,2,3)", "translate()", ")", "scale(2) x"}) {
    EXPECT_FALSE(parse_svg_transform(text)) << text;
  }
  std::string long_list;
  for (int i = 0; i < 100000; ++i) long_list += "scale(1)";
  EXPECT_FALSE(parse_svg_transform(long_list));
}

TEST(SvgTransform, inverses_undo) {
  const SvgTransform transform = *parse_svg_transform("matrix(1 2 3 4 5 6)");
  EXPECT_LT(glm::distance((*inverse(transform))(transform({7, 8})), glm::dvec2(7, 8)), 1e-12);
  EXPECT_FALSE(inverse(*parse_svg_transform("scale(0)")));
}

TEST(SvgTransform, knows_how_much_it_stretches) {
  EXPECT_EQ(largest_stretch({}), 1.0);
  EXPECT_EQ(largest_stretch(translation({5, 6})), 1.0);
  EXPECT_NEAR(largest_stretch(*parse_svg_transform("rotate(30) scale(2 -3) rotate(70)")), 3, 1e-12);
}

}  // namespace
}  // namespace pomona
