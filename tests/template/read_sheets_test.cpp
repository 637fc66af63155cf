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
  expect(with("M 4 -10", "M -4 -10"), 5, 9, "goes left of the axis");
  expect(with("hidden = true, color = \"#b9d48c\" }\nback = { part",
              "hidden = true, color = \"#b9d48c\" }\nback = { hidden = true, part"),
         1, 1, "have both sides hidden");
  expect(leaves + "outline = 0.5\nsway = \"1mm\"\n", 11, 1, "unknown key \"sway\"");
  std::string many = leaves + "outline = 0.5\naround = 200\nalong = 200\n";
  many.replace(many.find("count = 7"), 9, "count = 9");
  expect(many, 1, 1, "makes more than 1 000 000 triangles");
}

}  // namespace
}  // namespace pomona
