// Style files: their values, and every error with its place.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "render/style/shipped_styles.h"
#include "render/style/style_file.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

const std::string head = "format = 1\nkind = \"style\"\nname = \"mine\"\n";

TEST(StyleFile, SaysWhatIsNotStatedAsTheStructDoes) {
  const Style style = parse_style(head, "mine.toml");
  EXPECT_EQ(style.name, "mine");
  EXPECT_EQ(style.title, "mine");
  EXPECT_TRUE(style.ink);
  EXPECT_EQ(style.outline_width, Style{}.outline_width);
  EXPECT_FALSE(style.ink_color);
  EXPECT_FALSE(style.plate);
}

TEST(StyleFile, AsksForMarks) {
  const Style hatching =
      parse_style(head + "[marks]\nkind = \"hatching\"\nspacing = 0.02\nwidth = 0.01\nwash = 0.5\n", "mine.toml");
  ASSERT_TRUE(hatching.marks);
  EXPECT_EQ(hatching.marks->kind, MarkKind::hatching);
  EXPECT_EQ(hatching.marks->spacing + hatching.marks->width + hatching.marks->wash, 0.02 + 0.01 + 0.5);

  // By default dots are finer than lines.
  const Style stipple = parse_style(head + "[marks]\nkind = \"stipple\"\n", "mine.toml");
  EXPECT_EQ(stipple.marks->kind, MarkKind::stipple);
  EXPECT_LT(stipple.marks->width, MarkStyle{}.width);
  EXPECT_FALSE(parse_style(head, "mine.toml").marks);
  EXPECT_THROW(parse_style(head + "[marks]\nspacing = 0.02\n", "mine.toml"), Error);
}

TEST(StyleFile, IsReadKeyByKey) {
  const Style style =
      parse_style(head +
                      "title = \"Mine\"\n[ink]\nlines = false\ncolor = \"#000000\"\noutline = 0.01\n"
                      "inner = 0.02\ninner_opacity = 0.5\n[paper]\ncolor = \"#ffffff\"\ngrain = 0.03\n"
                      "vignette = 0.04\n[paint]\nnoise = false\nsaturation = 0.5\nlightness = -0.1\n"
                      "granulation = 2\ngloss = 3\n[light]\nazimuth = 90\nelevation = 45\nsoftness = 1\n"
                      "strength = 2\nambient = 0.5\nocclusion = 0.25\n[shadow]\ncolor = \"#ffffff\"\n"
                      "strength = 0.5\n[plate]\nmargin = 0.1\nletter_size = 0.05\nleader_width = 0.002\n"
                      "letter_color = \"#ffffff\"\ntitle = false\nlabels = false\nscale_bar = false\n",
                  "mine.toml");
  EXPECT_EQ(style.title, "Mine");
  EXPECT_FALSE(style.ink || style.noise);
  EXPECT_EQ(style.ink_color, Color(0));
  EXPECT_EQ(style.outline_width + style.inner_width, 0.01 + 0.02);
  EXPECT_EQ(style.inner_opacity, 0.5);
  EXPECT_EQ(style.paper, Color(1));
  EXPECT_EQ(style.grain + style.vignette, 0.03 + 0.04);
  EXPECT_EQ(style.saturation, 0.5);
  EXPECT_EQ(style.lightness, -0.1);
  EXPECT_EQ(style.granulation, 2);
  EXPECT_EQ(style.gloss, 3);
  EXPECT_NEAR(style.light.azimuth, pi / 2, 1e-12);
  EXPECT_NEAR(style.light.elevation, pi / 4, 1e-12);
  EXPECT_EQ(style.light.softness + style.light.strength + style.light.ambient + style.light.occlusion, 3.75);
  EXPECT_EQ(style.shadow.color, Color(1));
  EXPECT_EQ(style.shadow.strength, 0.5);
  ASSERT_TRUE(style.plate);
  EXPECT_EQ(style.plate->margin + style.plate->letter_size + style.plate->leader_width, 0.1 + 0.05 + 0.002);
  EXPECT_EQ(style.plate->letter_color, Color(1));
  EXPECT_FALSE(style.plate->title || style.plate->labels || style.plate->scale_bar);
}

struct Mistake {
  const char* text;  ///< after the head, from line 4 on
  int line, column;
  const char* message;
};

class StyleMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(StyleMistake, IsFoundWhereItIs) {
  try {
    parse_style(head + GetParam().text, "mine.toml");
    FAIL() << "nothing was found";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    const Diagnostic& first = error.diagnostics().front();
    EXPECT_EQ(first.place.file, "mine.toml");
    EXPECT_EQ(first.place.line, GetParam().line);
    EXPECT_EQ(first.place.column, GetParam().column);
    EXPECT_THAT(first.message, ::testing::HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(All, StyleMistake,
                         ::testing::Values(Mistake{"[inc]\n", 4, 2, "unknown key \"inc\""},
                                           Mistake{"[ink]\noutlin = 0.01\n", 5, 1, "unknown key \"outlin\""},
                                           Mistake{"[ink]\noutline = 1\n", 5, 11, "must lie between"},
                                           Mistake{"[ink]\nlines = 1\n", 5, 9, "lines"},
                                           Mistake{"[ink]\ncolor = \"black\"\n", 5, 9, "not a colour"},
                                           Mistake{"[paper]\ngrain = -1\n", 5, 9, "must lie between"},
                                           Mistake{"[paper]\ngrain = nan\n", 5, 9, "grain"},
                                           Mistake{"[light]\nelevation = 0\n", 5, 13, "must lie between"},
                                           Mistake{"[light]\nwindow = 1\n", 5, 10, "window"},
                                           Mistake{"[paint]\njuice = 2\n", 5, 9, "must lie between"},
                                           Mistake{"[plate]\nletter_size = \"3mm\"\n", 5, 15, "must be a number"},
                                           Mistake{"paint = 3\n", 4, 9, "table"}, Mistake{"[paper\n", 4, 7, ""}));

TEST(StyleFile, MustSayThatItIsOne) {
  EXPECT_THROW(parse_style("format = 1\nname = \"mine\"\n", "mine.toml"), Error);
  EXPECT_THROW(parse_style("format = 2\nkind = \"style\"\nname = \"mine\"\n", "mine.toml"), Error);
  EXPECT_THROW(parse_style("format = 1\nkind = \"fruit\"\nname = \"mine\"\n", "mine.toml"), Error);
  EXPECT_THROW(parse_style("format = 1\nkind = \"style\"\nname = \"My style\"\n", "mine.toml"), Error);
  EXPECT_THROW(parse_style("", "mine.toml"), Error);
}

TEST(StyleFile, ThatComesWithPomonaIsNamedAsItsFile) {
  for (const EmbeddedFile& shipped : shipped_styles()) {
    const auto file = std::filesystem::path(POMONA_SOURCE_DIR) / "styles" / shipped.name;
    EXPECT_TRUE(is_style_file(file)) << file;
    EXPECT_EQ(read_style(file).name, shipped.stem());
  }
  EXPECT_FALSE(is_style_file(std::filesystem::path(POMONA_SOURCE_DIR) / "templates/tomato.toml"));
  EXPECT_FALSE(is_style_file(std::filesystem::path(POMONA_SOURCE_DIR) / "scenes/salad.toml"));
}

TEST(StyleNamed, IsInkOrPlainOrAnErrorWithTheNearestName) {
  EXPECT_EQ(style_named("ink").outline_width, Style{}.outline_width);
  EXPECT_FALSE(style_named("plain").ink || style_named("plain").noise);
  EXPECT_TRUE(style_named("plate").plate.has_value());
  EXPECT_TRUE(style_named("photo").noise && style_named("photo").light.window && style_named("photo").juice > 0);
  EXPECT_FALSE(style_named("photo").ink);
  try {
    style_named("inc");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.diagnostics().front().hint, ::testing::HasSubstr("did you mean ink?"));
  }
}

TEST(StyleFile, IsMissingOrTooLongWithAnError) {
  EXPECT_THROW(read_style("no/such/style.toml"), Error);
  const TemporaryFolder folder;
  const std::string file = folder / "long.toml";
  std::ofstream(file) << head << "# " << std::string(70000, 'x') << "\n";
  EXPECT_THROW(read_style(file), Error);
}

}  // namespace
}  // namespace pomona
