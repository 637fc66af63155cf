// Painted sides in template files, and messages about mistakes.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

/// good.toml with the front of its skin, on line 17, or with another line in place of that.
std::string plum_text(const std::string& front) {
  std::ifstream stream(std::filesystem::path(POMONA_SOURCE_DIR) / "tests/template/good.toml", std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string from = "front = { part = \"skin\", color = \"#5b2a6e\", hidden = true }";
  return text.replace(text.find(from), from.size(), front);
}

Side skin_with(const std::string& keys) {
  return parse_template(plum_text("front = { part = \"skin\", " + keys + " }"), "plum.toml").surfaces[0].front;
}

Color color(const char* text) { return parse_color(text).value(); }

TEST(ReadPaint, a_colour_may_change_over_the_turn_and_from_fold_to_fold) {
  const Side side = skin_with(
      "color = { along = \"#804020\", turn = [[0.25, \"#ffffff\"], [0.5, \"#808080\"]], folds = [\"#ff0000\", "
      "\"#00ff00\"] }");
  EXPECT_EQ(side.color.along(0.3), color("#804020"));
  EXPECT_EQ(side.color.turn(0.25), Color(1));
  EXPECT_EQ(side.color.turn(0.5), color("#808080"));
  ASSERT_EQ(side.color.folds.size(), 2u);
  EXPECT_EQ(side.color.folds[1], Color(0, 1, 0));
}

TEST(ReadPaint, what_changes_over_the_turn_goes_on_over_the_seam) {
  // From 0.75 to 0.25 is half a turn: its middle has the mean colour.
  const Ramp<double> over = skin_with(
                                "color = \"#804020\", coats = [{ color = \"#ffffff\", "
                                "turn = [[0.25, 0.2], [0.75, 0.8]] }]")
                                .coats[0]
                                .turn;
  EXPECT_NEAR(over(0), 0.5, 1e-6);
  EXPECT_EQ(over(0), over(1));
  EXPECT_NEAR(over(0.125), 0.35, 1e-6);
  EXPECT_NEAR(over(0.875), 0.65, 1e-6);

  // One end alone counts for both; if both are given, the seam is intended.
  const auto turn = [](const std::string& stops) {
    return skin_with("color = \"#804020\", coats = [{ color = \"#ffffff\", turn = " + stops + " }]").coats[0].turn;
  };
  EXPECT_EQ(turn("[[0.0, 0.3], [0.5, 1]]")(1), 0.3);
  EXPECT_EQ(turn("[[0.5, 1], [1.0, 0.3]]")(0), 0.3);
  EXPECT_EQ(turn("[[0.0, 0.3], [1.0, 0.6]]")(1), 0.6);
  EXPECT_EQ(turn("[[0.4, 0.7]]")(0.9), 0.7);
  EXPECT_EQ(turn("0.7")(0.9), 0.7);
}

TEST(ReadPaint, coats_lie_over_the_ground) {
  const Side side = skin_with(
      "color = \"#804020\", coats = [{ color = [[0.0, \"#000000\"], [1.0, \"#ffffff\"]], along = 0.5, around = [[0.4, "
      "0], [0.5, 1], [0.6, 0]], folds = [1, 0.25] }, { color = \"#112233\" }]");
  ASSERT_EQ(side.coats.size(), 2u);
  const Coat& coat = side.coats[0];
  EXPECT_EQ(coat.color(1), Color(1));
  EXPECT_EQ(coat.along(0.1), 0.5);
  EXPECT_EQ(coat.around(0.5), 1);
  EXPECT_EQ(coat.around(0.1), 0);
  EXPECT_EQ(coat.turn(0.3), 1);
  EXPECT_EQ(coat.folds, (std::vector<double>{1, 0.25}));
}

TEST(ReadPaint, spots_are_scattered_or_lie_at_a_place) {
  const std::vector<SpotSketch> spots =
      skin_with(
          "color = \"#804020\", spots = [{ color = \"#402010\", spacing = \"4mm\", size = [\"1mm\", \"2mm\"], "
          "count = 9, band = [0.2, 0.8] }, { color = \"#c0a040\", place = [0.3, 200], size = \"30mm\", stretch = "
          "1.5, softness = 0.8, raggedness = 0.4, strength = 0.7, relief = \"-0.4mm\" }], hidden = true")
          .spots;
  ASSERT_EQ(spots.size(), 2u);
  EXPECT_FALSE(spots[0].place);
  EXPECT_DOUBLE_EQ(spots[0].spacing, 0.004);
  EXPECT_DOUBLE_EQ(spots[0].size_min, 0.001);
  EXPECT_DOUBLE_EQ(spots[0].size_max, 0.002);
  EXPECT_EQ(spots[0].count, 9);
  EXPECT_DOUBLE_EQ(spots[0].along_from, 0.2);
  EXPECT_DOUBLE_EQ(spots[0].along_to, 0.8);
  EXPECT_DOUBLE_EQ(spots[0].softness, 0.5);
  ASSERT_TRUE(spots[1].place);
  EXPECT_DOUBLE_EQ(spots[1].place->along, 0.3);
  EXPECT_DOUBLE_EQ(spots[1].place->azimuth, radians(200));
  EXPECT_DOUBLE_EQ(spots[1].size_max, 0.03);
  EXPECT_DOUBLE_EQ(spots[1].stretch, 1.5);
  EXPECT_DOUBLE_EQ(spots[1].softness, 0.8);
  EXPECT_DOUBLE_EQ(spots[1].raggedness, 0.4);
  EXPECT_DOUBLE_EQ(spots[1].strength, 0.7);
  EXPECT_EQ(spots[0].relief, 0);
  EXPECT_DOUBLE_EQ(spots[1].relief, -0.0004);
}

TEST(ReadPaint, blur_may_change_in_both_directions) {
  std::string text = plum_text("front = { part = \"skin\", color = \"#5b2a6e\", hidden = true }");
  const std::string from = "blur = \"0.4mm\"";
  text.replace(
      text.find(from), from.size(),
      "blur = { along = [[0.0, \"1mm\"], [1.0, \"3mm\"]], around = [[0.0, 0], [0.5, 1]], turn = [[0.25, 0.5]] }");
  const PaintedBlur blur = parse_template(text, "plum.toml").surfaces[1].blur;
  EXPECT_NEAR(blur.along(0.5), 0.002, 1e-9);
  EXPECT_EQ(blur.around(0.25), 0.5);
  EXPECT_EQ(blur.turn(0.8), 0.5);
}

// ---- Mistakes ----

struct Mistake {
  const char* keys;  ///< of the front; @ marks the mistake
  const char* message;
};

const Mistake mistakes[] = {
    {R"(color = @{ turn = "#ffffff" })", R"(front color lacks "along")"},
    {R"(color = { along = "#ffffff", turn = @[] })", R"(turn has no stops)"},
    {R"(color = { along = "#ffffff", folds = @[] })", R"(folds is empty)"},
    {R"(color = { along = "#ffffff", folds = @["#ffffff", "#ffffff", "#ffffff"] })",
     R"(folds has 3 values for 2 folds)"},
    {R"(color = { along = "#ffffff", folds = [@"#fff"] })", R"("#fff" is not a colour)"},
    {R"(color = { along = "#ffffff", folds = @"#ffffff" })", R"(folds must be an array)"},
    {R"(color = "#ffffff", coats = @{ color = "#ffffff" })", R"(coats must be an array)"},
    {R"(color = "#ffffff", coats = [@{ along = 0.5 }])", R"(lacks "color")"},
    {R"(color = "#ffffff", coats = [{ color = "#ffffff", along = @1.5 }])", R"(along is 1.5)"},
    {R"(color = "#ffffff", coats = [{ color = "#ffffff", turn = [[0.2, 1], [@0.1, 0]] }])", R"(does not ascend)"},
    {R"(color = "#ffffff", coats = [{ color = "#ffffff", @wide = 1 }])", R"(unknown key "wide")"},
    {R"(color = "#ffffff", spots = [@{ color = "#ffffff", size = "2mm" }])", R"(lacks "place" or "spacing")"},
    {R"(color = "#ffffff", spots = [@{ color = "#ffffff", spacing = "2mm" }])", R"(lacks "size")"},
    {R"(color = "#ffffff", spots = [@{ size = "2mm", spacing = "2mm" }])", R"(lacks "color")"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", spacing = @"0mm", size = "2mm" }])", R"(spacing is 0mm)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", spacing = "2mm", size = @["2mm", "1mm"] }])",
     R"(size is upside down)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", spacing = "2mm", size = @["2mm"] }])",
     R"(size is not a size)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", spacing = "2mm", size = @2 }])", R"(size must be a length)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = @[0.5], size = "2mm" }])", R"(is not a place)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [@1.5, 0], size = "2mm" }])",
     R"(must lie between 0 and 1)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, @400], size = "2mm" }])", R"(is 400)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", spacing = "2mm", size = "1mm", band = @[0.6, 0.2] }])",
     R"(band is empty)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", spacing = "2mm", size = "1mm", count = @0 }])",
     R"(count is 0)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", @spacing = "2mm" }])",
     R"(unknown key "spacing")"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", raggedness = @1 }])",
     R"(raggedness is 1)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", softness = @-1 }])",
     R"(softness is -1)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", strength = @2 }])",
     R"(strength is 2)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", stretch = @0 }])",
     R"(stretch is 0)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", relief = @"11mm" }])",
     R"(relief is 11mm)"},
    {R"(color = "#ffffff", spots = [{ color = "#ffffff", place = [0.5, 0], size = "1mm", relief = @0.3 }])",
     R"(relief must be a length)"},
};

/// The message at the place of the @, which is removed from the text.
std::string said_at_mark(std::string text) {
  const std::size_t mark = text.find('@');
  const int line =
      1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(mark), '\n'));
  const int column = static_cast<int>(mark - (text.rfind('\n', mark) + 1)) + 1;
  text.erase(mark, 1);
  std::string said, elsewhere;
  try {
    parse_template(text, "plum.toml");
  } catch (const Error& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      const bool is_there = diagnostic.place.line == line && diagnostic.place.column == column;
      (is_there ? said : elsewhere) += to_string(diagnostic) + "\n";
    }
  }
  return said.empty() ? "nothing, but elsewhere: " + elsewhere : said;
}

TEST(ReadPaint, each_mistake_is_found_where_it_is) {
  for (const Mistake& mistake : mistakes) {
    const std::string keys = mistake.keys;
    const std::string said = said_at_mark(plum_text("front = { part = \"skin\", " + keys + ", hidden = true }"));
    EXPECT_NE(said.find(mistake.message), std::string::npos) << keys << "\n" << said;
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(ReadPaint, what_a_surface_in_a_fold_or_a_grain_cannot_have_is_said) {
  const std::string good = plum_text("front = { part = \"skin\", color = \"#5b2a6e\", hidden = true }");
  const std::string stone = "color = \"#d89a2a\" }\nback = { part = \"stone\"";
  const std::string patch =
      R"(color = "#d89a2a", spots = [{ color = "#ffffff", size = "2mm", place = @[0.5, 0] }] })" + stone.substr(19);
  std::string said = said_at_mark(replaced(good, stone, patch));
  EXPECT_NE(said.find("is for surfaces around the axis only"), std::string::npos) << said;

  const std::string raised =
      R"(color = "#d89a2a", spots = [{ color = "#ffffff", size = "2mm", spacing = "5mm", relief = @"0.2mm" }] })" +
      stone.substr(19);
  said = said_at_mark(replaced(good, stone, raised));
  EXPECT_NE(said.find("is for sides that face air"), std::string::npos) << said;

  const std::string grain = "thickness = \"0.5mm\"\nfront = { part = \"flesh\", color = ";
  said = said_at_mark(replaced(good, grain + "\"#d89a2a\"", grain + R"({ along = "#d89a2a", @turn = "#ffffff" })"));
  EXPECT_NE(said.find("unknown key \"turn\""), std::string::npos) << said;
  said = said_at_mark(replaced(good, grain + "\"#d89a2a\"", grain + R"("#d89a2a", @spots = [])"));
  EXPECT_NE(said.find("unknown key \"spots\""), std::string::npos) << said;
}

TEST(ReadPaint, folds_are_for_fruit_with_folds) {
  const std::string said = said_at_mark(R"(
format = 1
name = "ball"
unit = "1mm"
parts = ["skin"]
symmetry = { kind = "cylindrical" }
[[surface]]
name = "skin"
type = "around-axis"
vertical = "M 0 0 L 9 -5 L 0 -9"
front = { part = "skin", color = "#ffffff", coats = [{ color = "#000000", folds = @[1] }] }
back = { part = "skin", color = "#ffffff" }
)");
  EXPECT_NE(said.find("speaks of folds, but the fruit has none"), std::string::npos) << said;
}

TEST(ReadPaint, lists_have_their_limits) {
  std::string coats, spots;
  for (int i = 0; i < 33; ++i) coats += "{ color = \"#ffffff\" }, ";
  for (int i = 0; i < 17; ++i) spots += "{ color = \"#ffffff\", size = \"1mm\", place = [0.5, 0] }, ";
  EXPECT_THROW(skin_with("color = \"#ffffff\", coats = [" + coats + "]"), Error);
  EXPECT_THROW(skin_with("color = \"#ffffff\", spots = [" + spots + "]"), Error);
}

}  // namespace
}  // namespace pomona
