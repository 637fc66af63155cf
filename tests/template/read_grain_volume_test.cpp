// [[grains]] that fill a surface.
#include <array>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

const std::string crumbs = R"([[grains]]
name = "crumbs"
inside = "skin"
front = { part = "flesh", color = "#d89a2a" }
back = { part = "flesh", hidden = true, color = "#d89a2a" }
)";

TEST(ReadGrainVolume, all_keys) {
  const Template plum = plum_and(crumbs + R"(
sizes = { from = "1mm", to = "5mm", exponent = 3, share = 0.2, near_skin = [["0mm", 0.4], ["8mm", 1.0]] }
proportions = [1.5, 1.0, 0.8]
heading = "around"
stray = 20
wall = "0.5mm"
apart = "0.3mm"
lumps = 0.2
clear_of = ["stone"]
)");
  const GrainSketch& grains = plum.grains.back();
  ASSERT_TRUE(grains.volume);
  EXPECT_EQ(grains.surface, 0);
  EXPECT_EQ(grains.volume->from, 0.001);
  EXPECT_EQ(grains.volume->to, 0.005);
  EXPECT_EQ(grains.volume->exponent, 3);
  EXPECT_EQ(grains.volume->share, 0.2);
  EXPECT_NEAR(grains.volume->near_skin(0.004), 0.7, 1e-6);
  EXPECT_EQ(grains.volume->heading, GrainVolume::Heading::around);
  EXPECT_NEAR(grains.volume->stray, radians(20), 1e-12);
  EXPECT_EQ(grains.volume->wall, 0.0005);
  EXPECT_EQ(grains.volume->apart, 0.0003);
  EXPECT_EQ(grains.volume->lumps, 0.2);
  EXPECT_EQ(grains.volume->clear_of, std::vector<int>{1});
  EXPECT_NEAR(grains.form.length, 0.0075, 1e-12);
  EXPECT_NEAR(grains.form.thickness, 0.004, 1e-12);
  EXPECT_TRUE(grains.back.hidden);
  EXPECT_FALSE(plum.grains.front().volume);
}

TEST(ReadGrainVolume, mistakes_are_found) {
  const auto expect = [](const std::string& more, int line, int column, const char* message) {
    const Mistake mistake{more.c_str(), line, column, message};
    expect_found(std::span(&mistake, 1));
  };
  const std::string sizes = "sizes = { from = \"1mm\", to = \"5mm\", share = 0.2 }\n";
  std::string in_fold = crumbs + sizes, unknown = crumbs + sizes;
  in_fold.replace(in_fold.find("\"skin\""), 6, "\"stone\"");
  unknown.replace(unknown.find("\"skin\""), 6, "\"skim\"");
  expect(in_fold, 3, 10, "lies in folds");
  expect(unknown, 3, 10, "\"skim\" is not known");
  expect(crumbs, 1, 1, "lacks \"sizes\"");
  expect(crumbs + "sizes = { from = \"1mm\", to = \"5mm\" }\n", 6, 9, "lacks \"share\"");
  expect(crumbs + "sizes = { from = \"6mm\", to = \"5mm\", share = 0.2 }\n", 6, 30, "is less than \"from\"");
  expect(crumbs + "sizes = { from = \"1mm\", to = \"5mm\", share = 0.7 }\n", 6, 45, "must lie between");
  expect(crumbs + sizes + "spacing = \"2mm\"\n", 7, 1, "unknown key \"spacing\"");
  expect(crumbs + sizes + "proportions = [1, 2]\n", 7, 15, "must be length, width and thickness");
}

}  // namespace
}  // namespace pomona
