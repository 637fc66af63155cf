#include "generator/text/svg_path.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/units.h"
#include "tests/base/german_locale.h"

namespace pomona {
namespace {

TEST(SvgPath, lines_are_scaled_and_turned_upwards) {
  const auto curves = parse_svg_path("M 0,0 L 10 0 v -20 h-10 Z", {.unit = 0.5});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed);
  const std::vector<glm::dvec2> expected = {{0, 0}, {5, 0}, {5, 10}, {0, 10}};
  EXPECT_EQ(curves[0].points, expected);
}

TEST(SvgPath, a_path_that_ends_where_it_began_is_closed) {
  EXPECT_TRUE(parse_svg_path("M0 0L10 0L10 10L0 0")[0].closed);
  EXPECT_FALSE(parse_svg_path("M0 0L10 0L10 10L1 0")[0].closed);
  EXPECT_EQ(parse_svg_path("M0 0L10 0L10 10L0 0z")[0].points.size(), 3u);
}

TEST(SvgPath, circles_of_arcs_stay_within_the_tolerance) {
  const auto curves = parse_svg_path("M 30 0 A 30 30 0 0 1 -30 0 A 30 30 0 0 1 30 0 Z");
  ASSERT_EQ(curves.size(), 1u);
  for (std::size_t i = 0; i < curves[0].points.size(); ++i) {
    const glm::dvec2 a = curves[0].points[i], b = curves[0].points[(i + 1) % curves[0].points.size()];
    EXPECT_NEAR(glm::length(a), 0.03, 1e-8);
    EXPECT_GE(glm::length(0.5 * (a + b)), 0.03 - 1.01e-5);
  }
  EXPECT_NEAR(std::fabs(signed_area(curves[0])), pi * 0.03 * 0.03, 2e-6);
}

TEST(SvgPath, arcs_take_the_way_their_flags_say) {
  // The four arcs of a circle between the same ends; y points up in the result.
  const auto middle = [](const std::string& flags) {
    return point_at(parse_svg_path("M -10 0 A 12.5 12.5 0 " + flags + " 10 0")[0], 0.5);
  };
  EXPECT_NEAR(middle("0 1").y, 0.005, 1e-5);
  EXPECT_NEAR(middle("0 0").y, -0.005, 1e-5);
  EXPECT_NEAR(middle("1 1").y, 0.020, 1e-5);
  EXPECT_NEAR(middle("1 0").y, -0.020, 1e-5);
  EXPECT_NEAR(point_at(parse_svg_path("M -10 0 A 20 5 30 0 1 10 0")[0], 1).x, 0.01, 1e-9);
}

/// The largest distance of the chords' middles from a cubic curve, in the drawing's units, y upwards as in the result.
double farthest_chord(const Curve& curve, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  double farthest = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const glm::dvec2 middle = 500.0 * (curve.points[i] + curve.points[i + 1]);
    double nearest = 1e9;
    for (int k = 0; k <= 4000; ++k) {
      const double t = k / 4000.0, s = 1 - t;
      nearest = std::min(nearest,
                         glm::distance(middle, s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(SvgPath, curves_stay_within_the_tolerance) {
  const auto curve = parse_svg_path("M0 0C40 10-20 30 10 50")[0];
  EXPECT_LT(farthest_chord(curve, {0, 0}, {40, -10}, {-20, -30}, {10, -50}), 0.02);
  EXPECT_NEAR(glm::distance(curve.points.back(), glm::dvec2(0.01, -0.05)), 0, 1e-9);
}

TEST(SvgPath, curves_that_bend_at_one_end_alone_stay_within_it_too) {
  EXPECT_LT(farthest_chord(parse_svg_path("M0 0C10 0 20 0 0 40")[0], {0, 0}, {10, 0}, {20, 0}, {0, -40}), 0.02);
  EXPECT_LT(farthest_chord(parse_svg_path("M0 40C20 0 10 0 0 0")[0], {0, -40}, {20, 0}, {10, 0}, {0, 0}), 0.02);
}

TEST(SvgPath, points_lie_on_the_grid) {
  const auto curves = parse_svg_path("M1.1 2.2Q3.3 4.4 5.5 1.1T9.9 1.7S4 4 3 3A7 3 20 1 0 1 1");
  for (const glm::dvec2& p : curves.at(0).points) {
    EXPECT_EQ(p.x * 0x1p30, std::floor(p.x * 0x1p30));
    EXPECT_EQ(p.y * 0x1p30, std::floor(p.y * 0x1p30));
  }
}

TEST(SvgPath, subpaths_are_curves) {
  EXPECT_EQ(parse_svg_path("M0 0h1v1z M5 5h1v1z").size(), 2u);
  EXPECT_EQ(parse_svg_path("M0 0h1v1z l 2 2 h 1").size(), 2u);
  EXPECT_EQ(parse_svg_path("").size(), 0u);
}

TEST(SvgPath, numbers_do_not_depend_on_the_locale) {
  const auto plain = parse_svg_path("M0.5 1.5L2.25 3")[0].points;
  const GermanLocale german;
  EXPECT_EQ(parse_svg_path("M0.5 1.5L2.25 3")[0].points, plain);
}

TEST(SvgPath, says_what_is_wrong) {
  const auto message = [](const std::string& data, const SvgPathOptions& options = {}) -> std::string {
    try {
      parse_svg_path(data, options);
    } catch (const BadPath& bad) {
      EXPECT_FALSE(bad.hint.empty());
      return bad.what();
    }
    return "";
  };
  using testing::HasSubstr;
  EXPECT_THAT(message("M 0 0 X 3"), HasSubstr("\"X\" after 6 characters"));
  EXPECT_THAT(message("M 0 0 C 1 2 3"), HasSubstr("missing or out of place"));
  EXPECT_THAT(message("L 0 0"), HasSubstr("missing or out of place"));
  EXPECT_THAT(message("M 0 0 L 1e999 0"), HasSubstr("beyond"));
  EXPECT_THAT(message("M 0 0 A 1e999 1 0 0 0 5 5"), HasSubstr("beyond"));
  EXPECT_THAT(message("M 0 0 A 5 5 1e999 0 0 5 5"), testing::_);
  EXPECT_THAT(message("M 0 0 C 9e5 9e5 -9e5 9e5 0 0", {.unit = 1e6}), HasSubstr("too long"));
  EXPECT_THAT(message("M 0 0 L 1 1 2 2 3 3 4 4", {.max_points = 3}), HasSubstr("more than 3 points"));
}

TEST(SvgPath, survives_anything) {
  // Random strings of the letters of path data give a result or BadPath; numbers are always finite.
  const RandomStream random({1, 0}, "svg path test");
  constexpr std::string_view letters = "MmZzLlHhVvCcSsQqTtAa0123456789+-.eE, ";
  std::uint64_t draw = 0;
  for (int n = 0; n < 20000; ++n) {
    std::string data = "M 1 2 ";
    for (std::uint64_t i = random.below(draw++, 40); i > 0; --i) data += letters[random.below(draw++, letters.size())];
    try {
      for (const Curve& curve : parse_svg_path(data)) {
        for (const glm::dvec2& p : curve.points) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << data;
      }
    } catch (const BadPath&) {
    }
  }
}

}  // namespace
}  // namespace pomona
