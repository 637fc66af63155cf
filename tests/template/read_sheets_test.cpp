// [[sheets]].
#include <array>

#include <gtest/gtest.h>

#include "generator/base/units.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

const std::string leaves = R"([[sheets]]
name = "leaves"
kind = "head"
count = 7
inner = "M 4 -10 C 6 -30, 4 -60, 0 -60"
outer = "M 8 -4 C 60 -10, 60 -90, 0 -90"
thickness = [[0.0, "2mm"], [1.2, "1mm"]]
front = { part = "skin", hidden = true, color = "#b9d48c" }
back = { part = "flesh", color = "#dfeab8" }
)";

TEST(ReadSheets, a_head_with_its_keys) {
  const Template plum = plum_and(leaves + R"(
outline = [[0.0, 0.2], [1.25, 0.4]]
law = { divergence = 144, jitter = 8 }
reach = [[0, 1.1], [1, 1.2]]
rib = { width = 0.1, height = "4mm" }
ruffle = { height = "1mm", waves = 5 }
veins = { color = "#ffffff", pairs = 6 }
gap = "0.3mm"
)");
  ASSERT_EQ(plum.sheets.size(), 1u);
  const SheetSketch& sheet = plum.sheets.front();
  EXPECT_EQ(sheet.kind, SheetSketch::Kind::head);
  EXPECT_EQ(sheet.count, 7);
  EXPECT_NEAR(sheet.divergence, radians(144), 1e-12);
  EXPECT_NEAR(sheet.outline(1.25), 0.4, 1e-7);
  EXPECT_NEAR(sheet.thickness(0.6), 0.0015, 1e-9);
  EXPECT_NEAR(sheet.rib.height(0.5), 0.004, 1e-9);
  EXPECT_EQ(sheet.ruffle.waves, 5);
  EXPECT_EQ(sheet.veins.pairs, 6);
  EXPECT_EQ(sheet.gap, 0.0003);
  EXPECT_NEAR(sheet.outer.points.front().y, 0.004, 1e-6) << "where the lowest drawn point is at 0";
  EXPECT_TRUE(plum_and("").sheets.empty());
}

const std::string pancakes = R"([[sheets]]
name = "pancakes"
kind = "stack"
count = 5
inner = "M 0 0 L 60 0"
outer = "M 0 -40 L 60 -40"
thickness = "5mm"
front = { part = "skin", hidden = true, color = "#b9d48c" }
back = { part = "flesh", color = "#dfeab8" }
)";

TEST(ReadSheets, a_stack_and_a_roll_with_their_keys) {
  const Template stack = plum_and(pancakes + R"(
horizontal = "M 10 0 L 0 -10 L -10 0 L 0 10 Z"
law = { divergence = 90, jitter = 5 }
stray = "2mm"
ruffle = { height = "1mm", waves = 5 }
)");
  EXPECT_EQ(stack.sheets.front().kind, SheetSketch::Kind::stack);
  EXPECT_EQ(stack.sheets.front().loop.points.size(), 4u);
  EXPECT_NEAR(stack.sheets.front().divergence, radians(90), 1e-12);
  EXPECT_EQ(stack.sheets.front().stray, 0.002);
  EXPECT_EQ(plum_and(pancakes).sheets.front().divergence, 0) << "layers lie as they are";
  std::string rolled = pancakes + "turns = 4.5\nsway = \"1mm\"\n";
  rolled.replace(rolled.find("stack"), 5, "roll");
  EXPECT_EQ(plum_and(rolled).sheets.front().turns, 4.5);
  EXPECT_EQ(plum_and(rolled).sheets.front().around, 72);
}

TEST(ReadSheets, mistakes_are_found) {
  const auto expect = [](const std::string& more, int line, int column, const char* message) {
    const Mistake mistake{more.c_str(), line, column, message};
    expect_found(std::span(&mistake, 1));
  };
  const auto with = [](const std::string& from, const std::string& to) {
    std::string changed = leaves + "outline = 0.5\n";
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  expect(leaves, 1, 1, "lacks \"outline\"");
  expect(with("\"head\"", "\"heap\""), 3, 8, "\"heap\" is not known");
  expect(with("count = 7", "count = 0"), 4, 9, "count is 0");
  expect(with("\"leaves\"", "\"skin\""), 2, 8, "is there already");
  expect(with("-90, 0 -90\"", "-90, 0 -90 Z\""), 6, 9, "is no open curve");
  expect(with("60, 0 -60\"", "60, 3 -60\""), 5, 9, "does not end on the axis");
  expect(with("-90, 0 -90\"", "-90, 3 -90\""), 6, 9, "does not end on the axis");
  expect(with("M 4 -10", "M -4 -10"), 5, 9, "goes left of the axis");
  expect(with("hidden = true, color = \"#b9d48c\" }\nback = { part",
              "hidden = true, color = \"#b9d48c\" }\nback = { hidden = true, part"),
         1, 1, "have both sides hidden");
  expect(leaves + "outline = 0.5\nsway = \"1mm\"\n", 11, 1, "unknown key \"sway\"");
  const auto stack = [](const std::string& from, const std::string& to) {
    std::string changed = pancakes;
    return changed.replace(changed.find(from), from.size(), to);
  };
  expect(stack("M 0 0 L 60 0", "M 0 0 L 60 0 L 50 5"), 5, 9, "does not run from the axis outwards");
  expect(stack("M 0 -40", "M 10 -40"), 6, 9, "does not run from the axis outwards");
  expect(pancakes + "horizontal = \"M 10 0 L 20 0 L 20 10 Z\"\n", 10, 14, "does not surround the axis");
  expect(pancakes + "turns = 3\n", 10, 1, "unknown key \"turns\"");
  expect(stack("\"stack\"", "\"roll\""), 1, 1, "lacks \"turns\"");
  std::string long_roll = stack("\"stack\"", "\"roll\"") + "turns = 60\naround = 200\nalong = 200\n";
  expect(long_roll, 1, 1, "makes more than 1 000 000 triangles");
  std::string many = leaves + "outline = 0.5\naround = 200\nalong = 200\n";
  many.replace(many.find("count = 7"), 9, "count = 9");
  expect(many, 1, 1, "makes more than 1 000 000 triangles");
}

}  // namespace
}  // namespace pomona
