// The table `cells` of a surface's side.
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "tests/template/plum.h"

namespace pomona {
namespace {

const std::string rind = R"([law.eyes]
kind = "spiral"
spacing = "6mm"
[[surface]]
name = "rind"
type = "around-axis"
vertical = "M 0 -80 C 8 -70, 8 -60, 0 -50"
)";

const std::string back = "back = { part = \"flesh\", color = \"#d89a2a\" }\n";

std::string with_front(const std::string& cells) {
  return rind + back + "front.part = \"skin\"\nfront.hidden = true\nfront.color = \"#d89a2a\"\n" + cells;
}

TEST(ReadCells, all_keys) {
  const Template plum = plum_and(with_front(R"(
[surface.front.cells]
law = "eyes"
color = [[0.0, "#5c4020"], [0.3, "#b8882e"]]
cover = [[0.0, 0.2], [1.0, 0.8]]
raise = [[0.0, "2mm"], [1.0, "-0.5mm"]]
along = [[0.0, 0.0], [0.1, 1.0]]
)"));
  const SurfaceSketch& surface = plum.surfaces.back();
  ASSERT_TRUE(surface.front.cells);
  EXPECT_FALSE(surface.back.cells);
  EXPECT_EQ(surface.front.cells->law, 0);
  EXPECT_NEAR(surface.front.cells->cover(0.5), 0.5, 1e-6);
  EXPECT_NEAR(surface.front.cells->raise(0), 0.002, 1e-12);
  EXPECT_NEAR(surface.front.cells->raise(1), -0.0005, 1e-12);
  EXPECT_NEAR(surface.front.cells->along(0.05), 0.5, 1e-6);
}

TEST(ReadCells, a_colour_covers_and_none_does_not) {
  const Template painted = plum_and(with_front("front.cells = { law = \"eyes\", color = \"#5c4020\" }\n"));
  EXPECT_EQ(painted.surfaces.back().front.cells->cover(0.5), 1);
  const Template bare = plum_and(with_front("front.cells = { law = \"eyes\", raise = \"1mm\" }\n"));
  EXPECT_EQ(bare.surfaces.back().front.cells->cover(0.5), 0);
}

TEST(ReadCells, mistakes_are_found) {
  const auto expect = [](const std::string& cells, int line, int column, const char* message) {
    const std::string text = with_front(cells);
    const Mistake mistake{text.c_str(), line, column, message};
    expect_found(std::span(&mistake, 1));
  };
  expect("front.cells = { raise = \"1mm\" }\n", 12, 15, "lacks \"law\"");
  expect("front.cells = { law = \"scales\" }\n", 12, 23, "\"scales\" is not known");
  expect("front.cells = { law = \"eyes\", raise = \"60mm\" }\n", 12, 39, "must lie between");
  expect("front.cells = { law = \"eyes\", cover = 0.5 }\n", 12, 15, "lacks \"color\"");
  expect("front.cells = { law = \"eyes\", color = \"#112233\", cover = 2 }\n", 12, 58, "must lie between");
  expect("front.cells = { law = \"eyes\", size = \"1mm\" }\n", 12, 31, "unknown key \"size\"");
}

TEST(ReadCells, only_one_side_raises) {
  const std::string text =
      rind +
      "front = { part = \"skin\", hidden = true, color = \"#d89a2a\", cells = { law = \"eyes\", raise = \"1mm\" } }\n" +
      "back = { part = \"flesh\", color = \"#d89a2a\", cells = { law = \"eyes\", raise = \"1mm\" } }\n";
  const Mistake mistake{text.c_str(), 9, 77, "is given beside that of the front"};
  expect_found(std::span(&mistake, 1));
}

TEST(ReadCells, lie_around_the_axis) {
  const std::string law = "[law.bunch]\nkind = \"cluster\"\nspacing = \"6mm\"\nenvelope = \"M 4 -80 L 8 -60\"\n";
  std::string text = with_front("front.cells = { law = \"bunch\" }\n");
  text = law + text;
  const Mistake mistake{text.c_str(), 16, 23, "is a cluster"};
  expect_found(std::span(&mistake, 1));
}

}  // namespace
}  // namespace pomona
