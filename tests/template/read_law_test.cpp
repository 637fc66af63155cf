// [law.NAME], and grains and spots that sit by it.
#include <array>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

const std::string seeds = R"(
[[grains]]
name = "seeds"
surface = "skin"
length = "1mm"
width = "1mm"
thickness = "1mm"
front = { part = "flesh", color = "#d89a2a" }
back = { part = "stone", color = "#7a4a20" }
)";

TEST(ReadLaw, all_kinds_with_their_keys) {
  const Template plum = plum_and(R"(
[law.eyes]
kind = "parastichies"
pair = [8, 13]
[law.ovules]
kind = "rows"
rows = 6
spacing = [[0.0, "2mm"], [1.0, "4mm"]]
twist = 90
band = [0.2, 0.8]
[law.leaves]
kind = "whorls"
count = 2
spacing = "9mm"
[law.spines]
kind = "spiral"
divergence = 99.5
spacing = "3mm"
jitter = 0.2
start = 30
)" + seeds + "law = \"ovules\"\nsize = [[0.0, 1.0], [1.0, 0.5]]\n");
  ASSERT_EQ(plum.laws.size(), 4u);
  EXPECT_EQ(plum.laws[0].high_pair, 13);
  EXPECT_EQ(plum.laws[1].count, 6);
  EXPECT_NEAR(plum.laws[1].spacing(0.5), 0.003, 1e-12);
  EXPECT_NEAR(plum.laws[2].turn, pi / 2, 1e-12) << "the gaps of the ring below";
  EXPECT_NEAR(plum.laws[3].divergence, radians(99.5), 1e-12);
  EXPECT_EQ(plum.grains.back().spacing.law, 1);
  EXPECT_NEAR(plum.grains.back().form.size(0.5), 0.75, 1e-6);
  EXPECT_FALSE(plum.grains.front().spacing.law);
}

TEST(ReadLaw, mistakes_are_found) {
  constexpr std::array mistakes{
      Mistake{"[law.a]\nspacing = \"2mm\"\n", 1, 1, "lacks \"kind\""},
      Mistake{"[law.a]\nkind = \"heap\"\nspacing = \"2mm\"\n", 2, 8, "\"heap\" is not known"},
      Mistake{"[law.a]\nkind = \"rows\"\nspacing = \"2mm\"\n", 1, 1, "lacks \"rows\""},
      Mistake{"[law.a]\nkind = \"spiral\"\nspacing = \"2mm\"\nrows = 3\n", 4, 1, "unknown key \"rows\""},
      Mistake{"[law.a]\nkind = \"parastichies\"\npair = [13, 8]\n", 3, 8, "are no spirals of this divergence"},
      Mistake{"[law.a]\nkind = \"parastichies\"\npair = [4, 9]\n", 3, 8, "are no spirals of this divergence"},
      Mistake{"[law.a]\nkind = \"spiral\"\nspacing = \"2mm\"\nband = [0.9, 0.1]\n", 4, 8, "band is empty"},
  };
  expect_found(mistakes);
}

TEST(ReadLaw, mistakes_of_its_users_are_found) {
  const std::string spiral = "[law.a]\nkind = \"spiral\"\nspacing = \"2mm\"\n";
  const auto expect = [](const std::string& more, int line, int column, const char* message) {
    const Mistake mistake{more.c_str(), line, column, message};
    expect_found(std::span(&mistake, 1));
  };
  expect(seeds + "law = \"a\"\n", 10, 7, "the template has no laws");
  expect(spiral + seeds + "law = \"b\"\n", 13, 7, "\"b\" is not known");
  expect(spiral + seeds + "law = \"a\"\nspacing = \"1mm\"\n", 14, 11, "beside a law");
  expect(spiral + seeds + "law = \"a\"\nsector = [0.1, 0.2]\n", 14, 10, "beside a law");
  std::string in_fold = seeds;
  in_fold.replace(in_fold.find("\"skin\""), 6, "\"stone\"");
  expect(spiral + in_fold + "law = \"a\"\n", 13, 7, "is for surfaces around the axis");
}

}  // namespace
}  // namespace pomona
