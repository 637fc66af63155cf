// Drawings are read exactly up to the limits, and refused beyond them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/template/bend_strain.h"
#include "generator/template/read/read_curve.h"
#include "generator/template/read/read_style.h"
#include "generator/template/read/read_template.h"
#include "generator/text/toml_document.h"

namespace pomona {
namespace {

using testing::HasSubstr;

std::string good_fruit() {
  std::ifstream stream(std::filesystem::path(POMONA_SOURCE_DIR) / "tests/template/good.toml", std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The messages about a text, after `read` has read it.
template <typename Read>
std::string complaint(const std::string& toml, Read read) {
  try {
    TomlDocument document(toml, "x.toml");
    read(document.root());
    document.throw_if_any();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(NoiseKeys, ThatWouldNotCountAreRefused) {
  const auto said = [](int keys, int bands) {
    std::string toml = "base_frequency = 100\n";
    for (int k = 0; k < keys; ++k) {
      toml += "[[key]]\ncolor = \"#ff0000\"\nweights = [0.1";
      for (int b = 1; b < bands; ++b) toml += ", 0.1";
      toml += "]\n";
    }
    return complaint(toml, [](const TomlTable& root) { read_noise(root); });
  };
  EXPECT_EQ(said(max_noise_keys, max_noise_bands), "");
  EXPECT_THAT(said(max_noise_keys + 1, 1), HasSubstr("x.toml"));
  EXPECT_THAT(said(1, max_noise_bands + 1), HasSubstr("has 9 numbers, but must have 1 to 8"));
}

TEST(TomlLengths, MayBeTheirLimitsAndAreToldThem) {
  const auto said = [](const std::string& length) {
    return complaint("w = \"" + length + "\"\n", [](const TomlTable& root) {
      root.get("w").length(0.003, {0.002, 0.005});
    });
  };
  for (const char* good : {"2mm", "0.5cm", "3mm"}) EXPECT_EQ(said(good), "") << good;
  for (const char* bad : {"1.999mm", "5.001mm"})
    EXPECT_THAT(said(bad), HasSubstr("must lie between 2mm and 5mm")) << bad;
}

TEST(NoiseLimits, AreThousandfoldEachWay) {
  const auto said = [](const std::string& stretch) {
    return complaint("base_frequency = 10\nstretch = [1, " + stretch + ", 1]\n",
                     [](const TomlTable& root) { read_noise(root); });
  };
  for (const char* good : {"0.001", "1", "1000"}) EXPECT_EQ(said(good), "") << good;
  for (const char* bad : {"0.0009", "1001"}) EXPECT_THAT(said(bad), HasSubstr("stretch")) << bad;
}

TEST(DrawnTemplate, KnowsHowItsDrawingLies) {
  // Points of the paths as they are written, y downwards, must lie on the curves as they are read, y upwards.
  const DrawnTemplate drawn = parse_drawn_template(good_fruit(), "plum.toml", {});
  ASSERT_TRUE(drawn.side && drawn.top);
  const auto nearest = [](const Curve& curve, const glm::dvec2& place) {
    double min = 1;
    for (const glm::dvec2& p : curve.points) min = std::min(min, glm::distance(p, place));
    return min;
  };
  const SurfaceSketch& skin = drawn.fruit.surfaces.at(0);
  for (const glm::dvec2& p : {glm::dvec2(0, 0), glm::dvec2(25, -25), glm::dvec2(0, -50)})
    EXPECT_LT(nearest(skin.vertical, (*drawn.side)(p)), 1e-6) << p.x << " " << p.y;
  for (const glm::dvec2& p : {glm::dvec2(25, 0), glm::dvec2(-25, 0)})
    EXPECT_LT(nearest(skin.horizontal.at(0), (*drawn.top)(p)), 1e-6) << p.x;
  EXPECT_GT((*drawn.side)(glm::dvec2(0, -50)).y, (*drawn.side)(glm::dvec2(0, 0)).y) << "up is up";
}

TEST(ReadDetail, scales_patterns_by_the_fruit_itself) {
  // The plum is 50 mm across and 50 mm high.
  const Template fruit = parse_template(
      good_fruit() + "\n[[detail]]\nkind = \"fibres\"\npart = \"flesh\"\nsize = \"1mm\"\namount = 0.5\n", "plum.toml");
  ASSERT_EQ(fruit.details.size(), 1u);
  EXPECT_NEAR(fruit.details[0].reach, 0.025, 1e-5);
  EXPECT_NEAR(fruit.details[0].middle, 0.025, 1e-5);
}

TEST(EndedOnAxis, TakesAwayWhatWaversAboutTheAxis) {
  Curve curve;
  curve.points = {{0.005, 0}, {-0.004, 0.1}, {-0.002, 0.2}, {0.5, 0.5},
                  {1, 1},     {0.6, 1.4},    {-0.006, 1.5}, {0.003, 1.6}};
  const Curve ended = ended_on_axis(curve);
  ASSERT_EQ(ended.points.size(), 5u);
  EXPECT_EQ(ended.points.front().x, 0);
  EXPECT_EQ(ended.points.back().x, 0);
  for (const glm::dvec2& p : ended.points) EXPECT_GE(p.x, 0);
  // An end more than a hundredth of the width off the axis is intended, no slip of the hand.
  curve.points.front().x = 0.0101;
  EXPECT_EQ(ended_on_axis(curve).points.front().x, 0.0101);
}

TEST(BendStrain, LeansAsFarAsTheAxisDoesAnywhere) {
  Template fruit = parse_template(good_fruit(), "plum.toml");
  for (const auto& [angle, swing] : {std::pair{0.3, 0.0}, {0.0, 0.4}, {0.2, 0.9}, {-0.5, 0.7}, {1.0, 0.1}}) {
    fruit.bend.angle = angle;
    fruit.bend.swing = swing;
    double max = 0;
    for (int i = -10000; i <= 10000; ++i) max = std::max(max, std::fabs(fruit.bend.lean(i / 10000.0)));
    EXPECT_NEAR(bend_strain(fruit).lean, max, 1e-7) << angle << " " << swing;
    EXPECT_GE(bend_strain(fruit).lean, max - 1e-15);
  }
}

}  // namespace
}  // namespace pomona
