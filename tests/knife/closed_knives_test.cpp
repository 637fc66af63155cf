// The surfaces of closed knives: they are closed, face outwards, do not cross themselves, and have the right size and
// depth.
#include "generator/knife/closed_knives.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"
#include "generator/knife/solid_of_revolution.h"
#include "generator/surface/crossings.h"
#include "generator/surface/skin_depth.h"
#include "tests/base/temporary_folder.h"
#include "tests/knife/closed_surface_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

DiffusionSurfaces as_surfaces(const ClosedSurface& solid) {
  std::vector<glm::vec3> position(solid.point.begin(), solid.point.end());
  return shapes::painted(std::move(position), solid.triangle, {});
}

/// Expects a surface that is closed, faces outwards and does not cross itself. Returns the height of its thinnest
/// triangle relative to the longest edge.
double expect_sound(const ClosedSurface& surface) {
  EXPECT_TRUE(is_closed(surface));
  EXPECT_GT(volume_of(surface), 0);
  EXPECT_EQ(crossing_triangles(as_surfaces(surface)).size(), 0u);
  return thinnest_of(surface);
}

DiffusionSurfaces ball_fruit(double radius = 0.035) {
  return shapes::moved(shapes::sphere(radius, 24, shapes::skin_paint()), {0, radius, 0});
}

ClosedSurface solid_of(const std::string& knife, const DiffusionSurfaces& fruit = ball_fruit()) {
  return surface_of(std::get<ClosedCut>(parse_knife(knife).cut), fruit);
}

glm::dvec3 middle_of(const ClosedSurface& solid) { return bounds_of(as_surfaces(solid)).center(); }

TEST(ClosedKnives, ABallIsABallWhereTheFruitIsSeen) {
  const ClosedSurface ball = solid_of("ball:24mm");
  EXPECT_GT(expect_sound(ball), 0.1) << "slivers";
  EXPECT_NEAR(volume_of(ball), 4. / 3 * pi * std::pow(0.012, 3), area_of(ball) * 0.000024);
  const glm::dvec3 front = middle_of(ball);
  EXPECT_NEAR(glm::distance(front, {0, 0.035, 0.035}), 0, 1e-4);
  double min = 1, max = 0;
  for (const glm::dvec3& p : ball.point) {
    min = std::min(min, glm::distance(p, {0, 0.035, front.z}));
    max = std::max(max, glm::distance(p, {0, 0.035, front.z}));
  }
  EXPECT_NEAR(min, 0.012, 2e-4);
  EXPECT_NEAR(max, 0.012, 2e-4);
  EXPECT_NEAR(glm::distance(middle_of(solid_of("ball:3cm,at=1cm,2cm,-3mm")), {0.01, 0.02, -0.003}), 0, 1e-7);
}

TEST(ClosedKnives, ABallIsWhereTheLineToTheAxisMeetsTheSkin) {
  // Off the axis the line meets the ball behind its foremost place; beside the ball it meets no skin.
  for (const double aside : {0.0, 0.01, 0.02, 0.03}) {
    const DiffusionSurfaces fruit = shapes::moved(ball_fruit(), {aside, 0, 0.005});
    const double depth = std::sqrt(0.035 * 0.035 - aside * aside);
    EXPECT_NEAR(glm::distance(middle_of(solid_of("ball:1cm", fruit)), {0, 0.035, 0.005 + depth}), 0, 2e-4) << aside;
  }
  const DiffusionSurfaces beside = shapes::moved(ball_fruit(), {0.1, 0, 0});
  EXPECT_NEAR(middle_of(solid_of("ball:1cm", beside)).z, 0.035, 1e-4);
}

TEST(ClosedKnives, ACorerFindsAFlatFruitWhereItLies) {
  const Box<double> bounds = bounds_of(as_surfaces(solid_of("core:1cm", shapes::open_sheet(0.1, 0.25))));
  EXPECT_LT(bounds.low.y, 0.25);
  EXPECT_GT(bounds.high.y, 0.25);
}

TEST(ClosedKnives, ACorerGoesThroughOrAsDeepAsAsked) {
  const ClosedSurface through = solid_of("core:18mm");
  EXPECT_GT(expect_sound(through), 0.1);
  const Box<double> bounds = bounds_of(as_surfaces(through));
  EXPECT_LT(bounds.low.y, -1e-3);
  EXPECT_GT(bounds.high.y, 0.071);
  const double cylinder = pi * 0.009 * 0.009 * bounds.size().y;
  EXPECT_NEAR(volume_of(through), cylinder, area_of(through) * 0.000018);

  EXPECT_NEAR(bounds_of(as_surfaces(solid_of("core:18mm,depth=4cm"))).low.y, 0.03, 1e-7);
  EXPECT_LT(bounds_of(as_surfaces(solid_of("core:18mm,depth=9cm"))).low.y, -1e-3) << "deeper than the fruit";
  const Box<double> level = bounds_of(as_surfaces(solid_of("core:10mm,at=0,3cm,0,axis=2,0,0")));
  EXPECT_NEAR(level.center().y, 0.03, 1e-6);
  EXPECT_GT(level.high.x, 0.036);
}

/// The distance of a bite's surface from its middle, along the ray at this angle, seen from the front.
std::vector<double> rim_of(const ClosedSurface& bite, const glm::dvec3& middle) {
  std::vector<std::pair<double, double>> rim;  // by angle
  for (const glm::dvec3& p : bite.point) {
    const glm::dvec3 arm = p - middle;
    if (std::fabs(arm.z) < 4e-4) rim.emplace_back(std::atan2(arm.y / 0.8, arm.x), std::hypot(arm.x, arm.y / 0.8));
  }
  std::sort(rim.begin(), rim.end());
  std::vector<double> radii;
  for (const auto& [angle, radius] : rim) radii.push_back(radius);
  return radii;
}

TEST(ClosedKnives, ABiteIsWiderThanHighAndNotOutOfShape) {
  const ClosedSurface bite = solid_of("bite:40mm");
  EXPECT_GT(expect_sound(bite), 0.03);
  const Box<double> bounds = bounds_of(as_surfaces(bite));
  EXPECT_NEAR(bounds.size().x, 0.04, 3e-3);
  EXPECT_NEAR(bounds.size().y, 0.8 * 0.04, 3e-3);
  EXPECT_NEAR(bounds.low.z, 0.035 - 0.5 * 0.8 * 0.04, 2e-3) << "deep";
  EXPECT_EQ(bite.point, solid_of("bite:40mm").point) << "the same width has the same teeth";
  expect_sound(solid_of("bite:30mm,at=0,7cm,0"));  // from the top, where no direction points towards the axis
  expect_sound(solid_of("bite:4mm"));
}

/// The rim is a row of grooves: each tooth reaches farther than the edges beside it. The teeth differ, so no turn maps
/// the rim onto itself.
TEST(ClosedKnives, ABiteHasTheMarksOfUnequalTeeth) {
  const std::vector<double> rim = rim_of(solid_of("bite:45mm"), {0, 0.035, 0.035});
  ASSERT_GT(rim.size(), 100u);
  std::vector<double> groove;  // how far each groove reaches
  const std::size_t n = rim.size(), near = n / 60;
  for (std::size_t i = 0; i < n; ++i) {
    bool largest = true;
    for (std::size_t k = 1; k <= near; ++k)
      largest = largest && rim[i] > rim[(i + k) % n] && rim[i] >= rim[(i + n - k) % n];
    if (largest) groove.push_back(rim[i]);
  }
  EXPECT_GE(groove.size(), 8u);
  EXPECT_LE(groove.size(), 24u);
  const auto [min, max] = std::minmax_element(groove.begin(), groove.end());
  EXPECT_GT(*max - *min, 0.02 * 0.0225);
}

class ProfileFile : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "knife.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg">
      <path id="cone" d="M 0,0 L 10,-20 0,-20"/>
      <path id="bowl" d="M 12,-40 L 4,-10"/>
      <path id="ring" d="M 10,0 L 14,0 14,-6 10,-6 Z"/>
      <path id="loop" d="M 0,0 L 20,0 5,-10 15,10 0,-30"/>
      <path id="beyond" d="M 0,0 L 20,0 -5,-10 0,-20"/>
      <path id="pinched" d="M 0,0 L 20,-5 0,-10 20,-15 0,-20"/>
      <path id="axis" d="M 0,0 L 0,-20"/>
      <path id="lid" d="M 10,0 L 10,-20 5,-20 5,10"/>
    </svg>)";
  }

  ClosedSurface solid(const std::string& what) {
    return surface_of(std::get<ClosedCut>(parse_knife("revolve:knife.svg#" + what, folder_.path()).cut), ball_fruit());
  }

  std::string message(const std::string& what, ExitStatus status) {
    try {
      solid(what);
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), status) << what;
      return error.what();
    }
    ADD_FAILURE() << what << " is accepted";
    return {};
  }

  const TemporaryFolder folder_;
};

/// [Pappus]: the area times the path length of its centre.
TEST_F(ProfileFile, IsRevolved) {
  const ClosedSurface cone = solid("cone");
  EXPECT_GT(expect_sound(cone), 0.05);
  EXPECT_NEAR(volume_of(cone), pi * 0.01 * 0.01 * 0.02 / 3, area_of(cone) * 2e-5);
  EXPECT_NEAR(bounds_of(as_surfaces(cone)).high.y, 0.02, 1e-7);

  const ClosedSurface bowl = solid("bowl");
  expect_sound(bowl);
  EXPECT_NEAR(volume_of(bowl), pi * 0.03 / 3 * (0.012 * 0.012 + 0.012 * 0.004 + 0.004 * 0.004), area_of(bowl) * 2.4e-5);

  const ClosedSurface ring = solid("ring");
  expect_sound(ring);
  EXPECT_NEAR(volume_of(ring), 2 * pi * 0.012 * 0.004 * 0.006, area_of(ring) * 2.8e-5);
}

TEST_F(ProfileFile, GoesWhereAskedAndIsScaled) {
  const Box<double> bounds = bounds_of(as_surfaces(solid("cone,scale=2mm,at=1cm,0,3cm,axis=1,0,0")));
  EXPECT_NEAR(bounds.low.x, 0.01, 1e-7);
  EXPECT_NEAR(bounds.high.x, 0.05, 1e-7);
  EXPECT_NEAR(bounds.high.z, 0.05, 1e-5);
  expect_sound(solid("cone,axis=-1,2,0.5"));
}

TEST_F(ProfileFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(
      message("loop", ExitStatus::bad_data),
      testing::AllOf(testing::HasSubstr("profile \"loop\" crosses itself"), testing::HasSubstr("knife.svg:5:")));
  EXPECT_THAT(message("beyond", ExitStatus::bad_data), testing::HasSubstr("knife.svg:6:"));
  EXPECT_THAT(message("beyond", ExitStatus::bad_data), testing::HasSubstr("crosses its axis"));
  EXPECT_THAT(message("pinched", ExitStatus::bad_data), testing::HasSubstr("meets its axis"));
  EXPECT_THAT(message("axis", ExitStatus::bad_data), testing::HasSubstr("encloses nothing"));
  EXPECT_THAT(message("lid", ExitStatus::bad_data), testing::HasSubstr("ends joined to the axis"));
  EXPECT_THAT(message("cnoe", ExitStatus::bad_data), testing::HasSubstr("no path"));
  message("cone,depth=3cm", ExitStatus::usage);
  message("cone,scale=0mm", ExitStatus::usage);
  message("cone,at=1,2", ExitStatus::usage);
  message("cone,axis=0,0,0", ExitStatus::usage);
  message("cone,axis=0,1,0,axis=1,0,0", ExitStatus::usage);
  EXPECT_THROW(parse_knife("revolve:other.svg#cone", folder_.path()), Error);
}

/// The largest error of the depth, at vertices and in the middles of triangles.
double offset_error(const ClosedSurface& solid, const DiffusionSurfaces& fruit, double thickness) {
  const SkinDepth skin(fruit);
  double worst = 0;
  for (const glm::uvec3& t : solid.triangle) {
    const glm::dvec3 middle = (solid.point[t.x] + solid.point[t.y] + solid.point[t.z]) / 3.0;
    for (const glm::dvec3& p : {solid.point[t.x], middle})
      worst = std::max(worst, std::fabs(skin.depth(p) - thickness));
  }
  return worst;
}

TEST(Peel, IsAsThickAsAsked) {
  for (const char* text : {"0.3mm", "2mm", "20mm"}) {
    SCOPED_TRACE(text);
    const double thickness = *parse_length(text);
    const ClosedSurface inner = solid_of(std::string("peel:") + text);
    EXPECT_GT(expect_sound(inner), 0.1) << "slivers";
    EXPECT_LT(offset_error(inner, ball_fruit(), thickness), 4e-5);
    const double radius = 0.035 - thickness;
    EXPECT_NEAR(volume_of(inner), 4. / 3 * pi * radius * radius * radius, area_of(inner) * 5e-5);
  }
}

TEST(Peel, FollowsWhatIsNoBall) {
  const DiffusionSurfaces ring = shapes::tilted(shapes::torus(0.04, 0.02, 96, 48));
  const ClosedSurface inner = solid_of("peel:3mm", ring);
  EXPECT_GT(expect_sound(inner), 0.1);
  EXPECT_LT(offset_error(inner, ring, 0.003), 1e-4);
  const DiffusionSurfaces box = shapes::box({-0.03, 0, -0.02}, {0.03, 0.05, 0.04}, 3, shapes::skin_paint());
  const ClosedSurface less = solid_of("peel:5mm", box);
  expect_sound(less);
  EXPECT_NEAR(volume_of(less), 0.05 * 0.04 * 0.05, 0.01 * 0.05 * 0.04 * 0.05) << "creases lose up to a cell";
}

/// The wall of the hollow does not count as skin.
TEST(Peel, IsThatOfTheOutside) {
  const ClosedSurface inner = solid_of("peel:12mm", shapes::hollow_ball(0.04, 0.03, 16));
  EXPECT_EQ(inner.point, solid_of("peel:12mm", shapes::sphere(0.04, 16, shapes::skin_paint())).point);
  expect_sound(inner);
}

DiffusionSurfaces ball_with_stem() {
  return joined(ball_fruit(), shapes::box({-0.002, 0.06, -0.002}, {0.002, 0.09, 0.002}, 2, shapes::skin_paint()));
}

/// Parts that stick out far are kept, with a little skin around them; small ones are peeled off.
TEST(Peel, LeavesTheStem) {
  const DiffusionSurfaces seed = shapes::box({0.034, 0.034, -0.001}, {0.036, 0.036, 0.001}, 1, shapes::skin_paint());
  const ClosedSurface inner = solid_of("peel:2mm", joined(ball_with_stem(), seed));
  expect_sound(inner);
  const Box<double> bounds = bounds_of(as_surfaces(inner));
  EXPECT_GT(bounds.high.y, 0.0905);
  EXPECT_NEAR(bounds.high.x, 0.033, 1e-4);
}

TEST(Peel, InOneStripHasARidgeBetweenItsTurns) {
  const DiffusionSurfaces fruit = ball_fruit();
  const ClosedSurface plain = solid_of("peel:2mm"), ridged = solid_of("peel:2mm,spiral=15mm");
  expect_sound(ridged);

  // The ridge is outside the skin along all turns of the strip.
  double out = 0;
  for (const glm::dvec3& p : ridged.point) out = std::max(out, glm::distance(p, {0, 0.035, 0}));
  EXPECT_GT(out, 0.0365);
  const double strip = 0.015, length = 4 * pi * 0.035 * 0.035 / strip, section = strip / 30 * (out - 0.033);
  EXPECT_NEAR(volume_of(ridged) - volume_of(plain), length * section, 0.15 * length * section);
}

TEST(Peel, SaysWhatCannotBePeeled) {
  const auto message = [](const std::string& knife, const DiffusionSurfaces& fruit, ExitStatus status) -> std::string {
    try {
      solid_of(knife, fruit);
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), status) << knife;
      return error.what() + (" / " + error.diagnostics().at(0).hint);
    }
    ADD_FAILURE() << knife << " is accepted";
    return {};
  };
  EXPECT_THAT(message("peel:4cm", ball_fruit(), ExitStatus::usage),
              testing::AllOf(testing::HasSubstr("peel of 40 mm is thicker than the fruit"),
                             testing::HasSubstr("34.9 mm under the skin")));
  EXPECT_THAT(message("peel:4cm", ball_with_stem(), ExitStatus::usage),
              testing::AllOf(testing::HasSubstr("peel of 40 mm is thicker than the fruit"),
                             testing::HasSubstr("its middle lies 34.")))
      << "what stays is no fruit";
  EXPECT_THAT(message("peel:2mm,spiral=0.1mm", ball_fruit(), ExitStatus::usage), testing::HasSubstr("too narrow"));
  EXPECT_THAT(message("peel:2mm", shapes::open_sheet(0.1, 0.02, 2, shapes::skin_paint()), ExitStatus::bad_data),
              testing::HasSubstr("closed"));
}

TEST(ClosedKnives, BadOnesAreUsageErrors) {
  for (const char* text : {"ball",
                           "ball:",
                           "ball:0mm",
                           "ball:-3mm",
                           "ball:11m",
                           "ball:1e300",
                           "ball:24mm,depth=2cm",
                           "ball:24mm,at=1,2",
                           "ball:24mm,at=1,2,3,4",
                           "ball:24mm,at=1,2,x",
                           "ball:24mm,at=1km,2,3",
                           "ball:24mm,3cm",
                           "ball:24mm,at=",
                           "core:",
                           "core:18mm,depth=0mm",
                           "core:18mm,depth=-1cm",
                           "core:18mm,axis=0,0,0",
                           "core:18mm,axis=nan,0,1",
                           "bite:0",
                           "bite:4cm,axis=0,0,1",
                           "peel:",
                           "peel:0mm",
                           "peel:2mm,spiral=0mm",
                           "peel:2mm,spiral",
                           "peel:2mm,at=0,0,0",
                           "peel:2mm,spiral=1cm,spiral=1cm",
                           "revolve:",
                           "revolve:profile.svg",
                           "revolve:#a"}) {
    SCOPED_TRACE(text);
    try {
      parse_knife(text);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::usage);
      EXPECT_THAT(error.what(), testing::HasSubstr(std::string("knife \"") + text + "\" "));
      EXPECT_THAT(error.diagnostics().at(0).hint,
                  testing::AnyOf(testing::StartsWith("it is written "), testing::StartsWith("it has "),
                                 testing::StartsWith("without a unit it is metres")));
    }
  }
}

}  // namespace
}  // namespace pomona
