// [ripeness], [browning] and the colours of [variation]: good.toml with more at its end.
#include "generator/template/read/read_ripeness.h"

#include <gtest/gtest.h>

#include "tests/template/plum.h"

namespace pomona {
namespace {

TEST(ReadRipeness, says_nothing_where_nothing_is_said) {
  const Template plum = plum_and("");
  EXPECT_FALSE(plum.ripeness.declared());
  EXPECT_FALSE(plum.browning.declared());
  EXPECT_FALSE(plum.variation.color.declared());
}

TEST(ReadRipeness, reads_all_there_is) {
  const RipenessSketch ripeness = plum_and(R"(
[ripeness]
spread = 2
height = [[0.0, 0.1], [1.0, 0.8]]
depth = [["0mm", 0.3], ["10mm", -0.1]]
patches = 0.25
patch_size = "8mm"
[[ripeness.part]]
part = "flesh"
colors = [[0.0, "#00ff00"], [0.5, "#ffff00"], [2.0, "#000000"]]
keep = 0.5
late = -0.2
[[ripeness.part]]
part = "skin"
colors = [[0.25, "#ff0000"]]
)")
                                      .ripeness;
  EXPECT_EQ(ripeness.spread, 2);
  EXPECT_NEAR(ripeness.height(0.5), 0.45, 1e-7);
  EXPECT_NEAR(ripeness.depth(0.005), 0.1, 1e-7);
  EXPECT_EQ(ripeness.patches, 0.25);
  EXPECT_NEAR(ripeness.patch_size, 0.008, 1e-12);
  ASSERT_EQ(ripeness.parts.size(), 2u);
  EXPECT_EQ(ripeness.parts[0].part, 1);
  EXPECT_EQ(ripeness.parts[0].keep, 0.5);
  EXPECT_EQ(ripeness.parts[0].late, -0.2);
  ASSERT_EQ(ripeness.parts[0].stops.size(), 3u);
  EXPECT_EQ(ripeness.parts[0].stops[1].at, 0.5);
  EXPECT_EQ(ripeness.parts[0].stops[1].value, Color(1, 1, 0));
  EXPECT_EQ(ripeness.parts[1].part, 0);
}

TEST(ReadBrowning, reads_all_there_is) {
  const BrowningSketch browning = plum_and(R"(
[browning]
depth = [["0mm", 0.2], ["2mm", 1.0]]
near = { surface = "stone", within = "4mm", faster = 2 }
patches = 0.3
patch_size = "5mm"
[[browning.part]]
part = "flesh"
color = "#ff0000"
rate = 1.5
most = 0.7
)")
                                      .browning;
  EXPECT_NEAR(browning.depth(0.001), 0.6, 1e-7);
  ASSERT_TRUE(browning.near.has_value());
  EXPECT_EQ(browning.near->surface, 1);
  EXPECT_NEAR(browning.near->within, 0.004, 1e-12);
  EXPECT_EQ(browning.near->faster, 2);
  ASSERT_EQ(browning.parts.size(), 1u);
  EXPECT_EQ(browning.parts[0].part, 1);
  EXPECT_EQ(browning.parts[0].color, Color(1, 0, 0));
  EXPECT_EQ(browning.parts[0].rate, 1.5);
  EXPECT_EQ(browning.parts[0].max, 0.7);
}

TEST(ReadColorVariation, is_one_number_or_one_for_each_part) {
  const ColorVariation all = plum_and("[variation]\ncolor = 0.02\nripeness = 0.2\n").variation.color;
  EXPECT_EQ(all.all, 0.02);
  EXPECT_EQ(all.ripeness, 0.2);
  EXPECT_TRUE(all.parts.empty());
  const ColorVariation parts = plum_and("[variation]\ncolor = { skin = 0.03, stone = 0.01 }\n").variation.color;
  EXPECT_EQ(parts.all, 0);
  EXPECT_EQ(parts.parts, (std::vector<double>{0.03, 0, 0.01}));
}

TEST(ReadTissues, the_first_leads) {
  const ColorVariation variation = plum_and("[variation]\ntissues = [[\"stone\", \"flesh\"]]\n").variation.color;
  ASSERT_EQ(variation.tissues.size(), 1u);
  EXPECT_EQ(variation.tissues.front(), (std::vector<int>{2, 1}));
}

const Mistake mistakes[] = {
    {"[ripeness]\n", 1, 1, "lacks \"part\""},
    {"[ripeness]\npart = 3\n", 2, 8, "must be"},
    {"[ripeness]\nspread = 11\n[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.0, \"#00ff00\"]]\n", 2, 10,
     "spread is 11"},
    {"[ripeness]\nheight = 2\n[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.0, \"#00ff00\"]]\n", 2, 10,
     "height is 2"},
    {"[ripeness]\ndepth = [[1, 2]]\n[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.0, \"#00ff00\"]]\n", 2, 11,
     "must be a length"},
    {"[ripeness]\ndepth = [[\"2mm\", 0], [\"1mm\", 1]]\n[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.0, "
     "\"#00ff00\"]]\n",
     2, 23, "does not ascend"},
    {"[ripeness]\ndepth = []\n[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.0, \"#00ff00\"]]\n", 2, 9,
     "has no stops"},
    {"[ripeness]\npatch_size = \"0mm\"\n[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.0, \"#00ff00\"]]\n", 2, 14,
     "patch_size is 0mm"},
    {"[[ripeness.part]]\npart = \"pit\"\ncolors = [[0.0, \"#00ff00\"]]\n", 2, 8, "\"pit\" is not known"},
    {"[[ripeness.part]]\npart = \"skin\"\n", 1, 1, "lacks \"colors\""},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = []\n", 3, 10, "has no stops"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[1.0, \"#00ff00\"]]\n", 3, 12, "is the drawn colour"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[2.5, \"#00ff00\"]]\n", 3, 12, "must lie between 0 and 2"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.5, \"#00ff00\"], [0.2, \"#00ff00\"]]\n", 3, 30,
     "does not ascend"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.5]]\n", 3, 11, "is not a stop"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.5, \"#00ff00\"]]\nkeep = 2\n", 4, 8, "keep is 2"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.5, \"#00ff00\"]]\n[[ripeness.part]]\npart = \"skin\"\ncolors "
     "= [[0.5, \"#00ff00\"]]\n",
     5, 8, "\"skin\" is there already"},
    {"[[ripeness.part]]\npart = \"skin\"\ncolors = [[0.5, \"#00ff00\"]]\nripe = 1\n", 4, 1, "unknown key \"ripe\""},
    {"[[browning.part]]\npart = \"flesh\"\n", 1, 1, "lacks \"color\""},
    {"[[browning.part]]\npart = \"flesh\"\ncolor = \"#ff0000\"\nrate = -1\n", 4, 8, "rate is -1"},
    {"[browning]\nnear = { surface = \"core\", within = \"1mm\", faster = 2 }\n[[browning.part]]\npart = "
     "\"flesh\"\ncolor = \"#ff0000\"\n",
     2, 20, "\"core\" is not known"},
    {"[browning]\nnear = { surface = \"stone\", within = \"0mm\", faster = 2 }\n[[browning.part]]\npart = "
     "\"flesh\"\ncolor = \"#ff0000\"\n",
     2, 38, "within is 0mm"},
    {"[variation]\ncolor = 0.5\n", 2, 9, "color is 0.5"},
    {"[variation]\ncolor = { pit = 0.01 }\n", 2, 11, "unknown key \"pit\""},
    {"[variation]\nripeness = \"late\"\n", 2, 12, "must be a number"},
    {"[variation]\ntissues = [[\"flesh\"]]\n", 2, 12, "must name two parts or more"},
    {"[variation]\ntissues = [[\"flesh\", \"pit\"]]\n", 2, 22, "\"pit\" is not known"},
    {"[variation]\ntissues = [[\"flesh\", \"flesh\"]]\n", 2, 22, "\"flesh\" is there already"},
    {"[variation]\ntissues = [[\"skin\", \"flesh\"]]\ncolor = { flesh = 0.1 }\n", 3, 19, "follows \"skin\""},
};

TEST(ReadRipeness, mistakes_are_found_where_they_are) { expect_found(mistakes); }

}  // namespace
}  // namespace pomona
