// pomona sketch: its files can be checked, grown and cut; its colours are those of the picture.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/color.h"
#include "generator/template/read/read_template.h"
#include "render/image/png.h"
#include "tests/cli/run_pomona.h"

namespace fs = std::filesystem;

namespace pomona::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

void write(const std::string& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// 200 x 100 pixels: red grows to the right, green downwards, blue is speckled.
std::string gradient() {
  Image image{.width = 200, .height = 100, .pixels = {}};
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) image.pixels.emplace_back(x, 2 * y, (7 * x + 13 * y) % 17 == 0 ? 255 : 40);
  }
  return write_png(image);
}

// ---- Starting ----

class Started : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Started, CanBeCheckedGrownAndCut) {
  const TemporaryFolder folder;
  write(folder / "photo 1.png", gradient());
  std::vector<std::string> words = {"sketch", "fig.toml"};
  words.insert(words.end(), GetParam().begin(), GetParam().end());
  const Outcome started = run_pomona(words, folder.path());
  ASSERT_EQ(started.status, 0) << started.err;
  EXPECT_THAT(started.err, HasSubstr("fig.svg"));

  const Outcome checked = run_pomona({"check", "fig.toml"}, folder.path());
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.err, Not(HasSubstr("warning")));
  for (const char* seed : {"0", "3"}) {
    const Outcome cut = run_pomona({"cut", "fig.toml", "--knife", "half", "--knife", "across", "--seed", seed,
                                    "--detail", "0.3", "--quality", "draft", "-o", "x.ply"},
                                   folder.path());
    EXPECT_EQ(cut.status, 0) << cut.err;
    EXPECT_THAT(cut.err, Not(HasSubstr("warning")));
  }
  EXPECT_EQ(run_pomona({"grow", "fig.toml", "--sheets", "--detail", "0.4", "-o", "y.ply"}, folder.path()).status, 0);
}

INSTANTIATE_TEST_SUITE_P(Sketches, Started,
                         ::testing::Values(std::vector<std::string>{}, std::vector<std::string>{"--cylindrical"},
                                           std::vector<std::string>{"--folds", "1"},
                                           std::vector<std::string>{"--folds", "2"},
                                           std::vector<std::string>{"--folds", "5"},
                                           std::vector<std::string>{"--folds", "13"},
                                           std::vector<std::string>{"--picture", "photo 1.png"},
                                           std::vector<std::string>{"--picture-above", "photo 1.png"},
                                           std::vector<std::string>{"--picture", "photo 1.png", "--picture",
                                                                    "photo 1.png", "--folds", "3"}));

TEST(Sketch, WritesOverNothing) {
  const TemporaryFolder folder;
  write(folder / "fig.svg", "mine");
  const Outcome refused = run_pomona({"sketch", "fig.toml"}, folder.path());
  EXPECT_EQ(refused.status, 73);
  EXPECT_THAT(refused.err, HasSubstr("fig.svg: error: it is there already"));
  EXPECT_EQ(bytes_of(folder / "fig.svg"), "mine");
  EXPECT_FALSE(fs::exists(folder / "fig.toml")) << "both or none";
  EXPECT_EQ(run_pomona({"sketch", "fig.toml", "--force"}, folder.path()).status, 0);
  EXPECT_EQ(run_pomona({"check", "fig.toml"}, folder.path()).status, 0);
  EXPECT_EQ(run_pomona({"sketch", "fig.toml"}, folder.path()).status, 73);
}

TEST(Sketch, RefusesWhatCannotBe) {
  const TemporaryFolder folder, elsewhere;
  write(folder / "photo.png", gradient());
  write(folder / "photo.jpg", "\xff\xd8\xff\xe0 JFIF");
  write(elsewhere / "photo.png", gradient());
  const auto refused = [&](std::vector<std::string> words, int status, const char* says) {
    words.insert(words.begin(), "sketch");
    const Outcome outcome = run_pomona(words, folder.path());
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(says));
    EXPECT_FALSE(fs::exists(folder / "fig.toml"));
    EXPECT_FALSE(fs::exists(folder / "fig.svg"));
  };
  refused({}, 64, "FILE");
  refused({"fig.svg"}, 64, "ends in .toml");
  refused({"Fig.toml"}, 64, "not a plain name");
  refused({"nowhere/fig.toml"}, 73, "folder");
  refused({"fig.toml", "--folds", "65"}, 64, "--folds");
  refused({"fig.toml", "--folds", "3", "--cylindrical"}, 64, "--cylindrical");
  refused({"fig.toml", "--picture", "none.png"}, 66, "no such file");
  refused({"fig.toml", "--picture", "photo.jpg"}, 65, "no PNG");
  write(elsewhere / "photo.png", gradient() + "of another day");
  refused({"fig.toml", "--picture", elsewhere / "photo.png"}, 73, "has its name here");
  refused({"fig.toml", "--picture", "photo.png", "--picture-above", "photo.png"}, 64, "--picture-above");
  refused({"fig.toml", "--picture", "photo.png", "--picture", "photo.png", "--picture", "photo.png"}, 64, "two");
  refused({"fig.toml", "--like", "kidney"}, 64, "meshes");
  refused({"fig.toml", "--like", "lemmon"}, 66, "did you mean lemon?");
  refused({"fig.toml", "--like", "lemon", "--folds", "3"}, 64, "--like");
  refused({"fig.toml", "--like", "lemon", "--cylindrical"}, 64, "--like");
  refused({"fig.toml", "--sample"}, 66, "no such file");
  refused({"fig.toml", "--sample", "--force"}, 64, "--sample");
}

TEST(Sketch, CopiesAPictureThatLiesElsewhere) {
  const TemporaryFolder folder, elsewhere;
  write(elsewhere / "ph oto.png", gradient());
  const std::vector<std::string> words = {"sketch", "fig.toml", "--force", "--picture", elsewhere / "ph oto.png"};
  for (int again = 0; again < 2; ++again) {
    const Outcome outcome = run_pomona(words, folder.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("copied ph oto.png") != std::string::npos, again == 0) << outcome.err;
    EXPECT_EQ(bytes_of(folder / "ph oto.png"), gradient());
    EXPECT_THAT(bytes_of(folder / "fig.svg"), HasSubstr("xlink:href=\"ph%20oto.png\""));
  }
}

TEST(Sketch, OverAPictureFromAboveTakesNoColoursFromTheSide) {
  const TemporaryFolder folder;
  write(folder / "photo.png", gradient());
  EXPECT_EQ(run_pomona({"sketch", "fig.toml", "--picture-above", "photo.png"}, folder.path()).status, 0);
  const std::string svg = bytes_of(folder / "fig.svg");
  const std::size_t picture = svg.find("<image"), top = svg.find("inkscape:label=\"top view\"");
  ASSERT_NE(picture, std::string::npos);
  EXPECT_GT(picture, top) << "it lies in the layer of the side view";
  EXPECT_EQ(svg.find("<image", picture + 1), std::string::npos);
  EXPECT_EQ(bytes_of(folder / "fig.toml").find("sample ="), std::string::npos);
}

TEST(Sketch, LikeAnotherIsThatFruitUnderItsOwnName) {
  const TemporaryFolder folder;
  const std::vector<std::string> cut = {"--knife", "across", "--section", "--quiet", "--detail", "0.3", "-o"};
  for (const char* like : {"lemon", "okra"}) {
    const Outcome outcome = run_pomona({"sketch", "blood_orange.toml", "--force", "--like", like}, folder.path());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string text = bytes_of(folder / "blood_orange.toml");
    EXPECT_THAT(text, HasSubstr("name = \"blood_orange\"\ntitle = \"blood orange\"\n"));
    EXPECT_EQ(text.find("latin"), std::string::npos);
    EXPECT_EQ(run_pomona({"check", "blood_orange.toml"}, folder.path()).status, 0);

    std::vector<std::string> copy = {"cut", "blood_orange.toml"}, original = {"cut", like};
    copy.insert(copy.end(), cut.begin(), cut.end());
    original.insert(original.end(), cut.begin(), cut.end());
    copy.emplace_back("copy.ply");
    original.emplace_back("original.ply");
    EXPECT_EQ(run_pomona(copy, folder.path()).status, 0);
    EXPECT_EQ(run_pomona(original, folder.path()).status, 0);
    EXPECT_EQ(bytes_of(folder / "copy.ply"), bytes_of(folder / "original.ply"));
  }
}

// ---- Colours ----

/// A template and an SVG with one line "colours" over one image.
class Sampled : public ::testing::Test {
 protected:
  void draw(const std::string& image, const std::string& line, const std::string& color) {
    write(
        folder_ / "fig.svg", R"svg(<svg width="200mm" viewBox="0 0 200 200" xmlns:xlink="http://www.w3.org/1999/xlink">
<g id="side-view">
<line id="axis" x1="100" y1="90" x2="100" y2="0"/>
<path id="skin" d="M100,80 L140,40 L100,0"/>
)svg" + image + "\n" + line + "\n</g>\n</svg>\n");
    write(folder_ / "fig.toml", R"toml(format = 1
name = "fig" # stays
sketch = "fig.svg"
parts = ["skin"]
[symmetry]
kind = "cylindrical"
[[surface]]
name = "skin"
type = "around-axis"
vertical = "#skin"
front = { part = "skin", color = )toml" +
                                    color + R"toml(, hidden = true } # "] stays
back = { part = "skin", color = "#102030" }
)toml");
  }

  Outcome sample() { return run_pomona({"sketch", "fig.toml", "--sample"}, folder_.path()); }

  /// The colours of the skin's front as 8-bit sRGB.
  std::vector<glm::ivec3> colors() {
    std::vector<glm::ivec3> found;
    const Template fruit = read_template(folder_ / "fig.toml");
    for (const auto& stop : fruit.surfaces[0].front.color.along.stops) {
      found.emplace_back(to_srgb8(stop.value));
    }
    return found;
  }

  void expect_colors(const std::vector<glm::ivec3>& wanted) {
    const std::vector<glm::ivec3> found = colors();
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[i][c], wanted[i][c], 2) << "stop " << i << ", channel " << c;
    }
  }

  TemporaryFolder folder_;
};

const std::string plain_image = R"(<image x="20" y="10" width="100" height="50" xlink:href="photo.png"/>)";

TEST_F(Sampled, AreThoseUnderTheLineFromTheBottomUp) {
  write(folder_ / "photo.png", gradient());
  // Two pixels per unit. The line goes down, from pixel 40,20 to 120,80.
  draw(plain_image, R"(<path id="colours" d="M40,20 L80,50"/>)", R"({ sample = "#colours", stops = 3 })");
  EXPECT_EQ(run_pomona({"check", "fig.toml"}, folder_.path()).status, 65) << "not sampled yet";
  const std::string before = bytes_of(folder_ / "fig.toml");
  const Outcome outcome = sample();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_colors({{120, 160, 40}, {80, 100, 40}, {40, 40, 40}});

  // Nothing else changes, and a second run changes nothing.
  std::string after = bytes_of(folder_ / "fig.toml");
  const std::size_t from = after.find(", along = ["), to = after.find("]]", from) + 2;
  EXPECT_EQ(after.substr(0, from) + after.substr(to), before);
  EXPECT_EQ(sample().status, 0);
  EXPECT_EQ(bytes_of(folder_ / "fig.toml"), after);

  // The template no longer needs the picture.
  fs::remove(folder_ / "photo.png");
  EXPECT_EQ(run_pomona({"check", "fig.toml"}, folder_.path()).status, 0);
  const Outcome missing = sample();
  EXPECT_EQ(missing.status, 66);
  EXPECT_THAT(missing.err, HasSubstr("fig.svg:5:1: error: the picture photo.png is not there"));
  EXPECT_EQ(bytes_of(folder_ / "fig.toml"), after);
}

TEST_F(Sampled, FollowThePicturesTransform) {
  write(folder_ / "photo.png", gradient());
  // Turned by a quarter: the pixel u,v is at x = 150 - v, y = 20 + u (one pixel per unit).
  draw(R"svg(<g transform="translate(150,20)"><image transform="rotate(90)" width="200" height="100" href="photo.png"/>
</g>)svg",
       R"(<path id="colours" d="M110,140 L70,60"/>)", R"({ sample = "#colours", along = "#ffffff", stops = 2 })");
  const Outcome outcome = sample();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_colors({{120, 80, 40}, {40, 160, 40}});
}

TEST_F(Sampled, KeepThePicturesShapeInItsBox) {
  write(folder_ / "photo.png", gradient());
  // In a square of 100 the picture fills the middle half: pixel 40,50 is at 40,60. Old stops are removed in any
  // notation.
  draw(R"(<image x="20" y="10" width="100" height="100" href="photo.png"/>)",
       R"(<path id="colours" d="M80,60 L40,60"/>)",
       "{ sample = \"#colours\", stops = 2, along = [ # ] in a comment\n [0, \"#111111\"],\n [1, \"#222222\"] ] }");
  const Outcome outcome = sample();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_colors({{120, 100, 40}, {40, 100, 40}});
}

TEST_F(Sampled, MayComeFromAnEmbeddedPicture) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string bytes = gradient();
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u; };
    const unsigned three = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    for (int k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63u];
    if (i % 57 == 0) text += "\n";
  }
  draw(R"(<image x="20" y="10" width="100" height="50" xlink:href="data:image/png;base64,)" + text + "\"/>",
       R"(<path id="colours" d="M40,20 L80,50"/>)", R"({ sample = "#colours", stops = 2 })");
  const Outcome outcome = sample();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_colors({{120, 160, 40}, {40, 40, 40}});
}

/// The picture is twice as wide as it is high. Its left half is red, its right half blue.
TEST_F(Sampled, AreWhereThePictureLiesInItsBox) {
  constexpr const char* halves =
      "iVBORw0KGgoAAAANSUhEUgAAAAQAAAACCAIAAADwyuo0AAAAE0lEQVR42mP4z8AARGDiPwMyBwBnsgf595JWggAAAABJRU5ErkJg"
      "gg==";
  const auto colour_at = [&](int x, const std::string& box) {
    draw("<image " + box + R"( xlink:href="data:image/png;base64,)" + std::string(halves) + "\"/>",
         "<path id=\"colours\" d=\"M" + std::to_string(x) + ",40 V39\"/>", R"({ sample = "#colours", stops = 2 })");
    const Outcome outcome = sample();
    return outcome.status == 0 ? (colors()[0].x > 128 ? "red" : "blue") : "beside";
  };
  const std::string wide = R"(x="0" y="0" width="180" height="60" preserveAspectRatio=")",
                    high = R"(x="0" y="0" width="60" height="60" preserveAspectRatio=")";
  // It is 120 wide.
  EXPECT_STREQ(colour_at(10, wide + "xMinYMid\""), "red");
  EXPECT_STREQ(colour_at(70, wide + "xMinYMid meet\""), "blue");
  EXPECT_STREQ(colour_at(130, wide + "xMinYMid meet\""), "beside");
  EXPECT_STREQ(colour_at(70, wide + "\""), "red");
  EXPECT_STREQ(colour_at(110, wide + "xMaxYMin\""), "red");
  EXPECT_STREQ(colour_at(50, wide + "xMaxYMin\""), "beside");
  EXPECT_STREQ(colour_at(70, wide + "none\""), "red");
  EXPECT_STREQ(colour_at(50, high + "xMinYMid slice\""), "red");
  EXPECT_STREQ(colour_at(10, high + "xMaxYMid slice\""), "blue");
  EXPECT_STREQ(colour_at(40, high + "xMidYMid slice\""), "blue");
}

TEST_F(Sampled, APictureWhosePlaceIsNotKnownIsNamed) {
  write(folder_ / "photo.png", gradient());
  const std::string line = R"(<path id="colours" d="M40,20 L80,50"/>)", color = R"({ sample = "#colours" })";
  for (const auto& [image, why] :
       {std::pair{R"(width="50%" height="50")", "a length that cannot be read: width=\"50%\""},
        {R"(width="50")", "does not say how large it is"},
        {R"(width="50" height="50" style="x:9px")", "has its shape from its style (CSS)"},
        {R"(width="50" height="50" transform="none")", "a transform that cannot be read"}}) {
    draw("<image " + std::string(image) + R"( xlink:href="photo.png"/>)", line, color);
    const Outcome outcome = sample();
    EXPECT_EQ(outcome.status, 65) << why;
    EXPECT_THAT(outcome.err, HasSubstr("fig.svg:5:1")) << why;
    EXPECT_THAT(outcome.err, HasSubstr(why));
  }
}

TEST_F(Sampled, WhatIsTransparentIsNoPicture) {
  // Four pixels, RGBA: red, red but transparent, green, green. (Made by ImageMagick.)
  constexpr const char* cut_out =
      "iVBORw0KGgoAAAANSUhEUgAAAAQAAAABCAYAAAD5PA/NAAAAF0lEQVQI1wXBAQEAAACCIPo/2mARtgQHKQoEAK2Y2AEAAAAASUVO"
      "RK5CYII=";
  const std::string below = R"(<image x="20" y="10" width="80" height="20" xlink:href="photo.png"/>)";
  const std::string above = R"(<image x="20" y="10" width="80" height="20" preserveAspectRatio="none")"
                            R"( xlink:href="data:image/png;base64,)" +
                            std::string(cut_out) + "\"/>";
  const std::string line = R"(<path id="colours" d="M50,20 L30,20"/>)", color = R"({ sample = "#colours", stops = 2 })";
  write(folder_ / "photo.png", gradient());
  draw(above, line, color);
  EXPECT_EQ(sample().status, 65);
  draw(below + above, line, color);
  const Outcome outcome = sample();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(colors()[1], glm::ivec3(255, 0, 0));
  EXPECT_NE(colors()[0], glm::ivec3(255, 0, 0)) << "the picture below shows through";
}

TEST_F(Sampled, SayWhatIsWrong) {
  write(folder_ / "photo.png", gradient());
  write(folder_ / "broken.png", gradient().substr(0, 300));
  std::string vast = gradient();
  vast[16] = vast[20] = 1;  // 16 million pixels along each side
  write(folder_ / "vast.png", vast);
  write(folder_ / "photo.jpg", "\xff\xd8\xff\xe0 JFIF");
  const std::string line = R"(<path id="colours" d="M40,20 L80,50"/>)", color = R"({ sample = "#colours" })";
  const auto says = [&](const std::string& message, int status = 65) {
    const std::string before = bytes_of(folder_ / "fig.toml");
    const Outcome outcome = sample();
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(bytes_of(folder_ / "fig.toml"), before);
  };
  for (const char* href :
       {"../photo.png", "/tmp/photo.png", "http://x.org/photo.png", "file:///tmp/photo.png", "%2e%2e/p.png"}) {
    draw(R"(<image x="20" y="10" width="100" height="50" xlink:href=")" + std::string(href) + "\"/>", line, color);
    says("fig.svg:5:1: error: the picture lies outside the template's folder");
  }
  for (const auto& [href, message] : {std::pair{"photo.jpg", "no PNG"},
                                      {"broken.png", "not a readable PNG"},
                                      {"vast.png", "100 million"},
                                      {"data:image/png;base64,?", "not base64"},
                                      {"data:x", "not base64"}}) {
    draw(R"(<image x="20" y="10" width="100" height="50" xlink:href=")" + std::string(href) + "\"/>", line, color);
    says(message);
  }
  draw(plain_image, R"(<path id="colours" d="M80,50 L40,0"/>)", color);
  says("fig.toml:11:45: error: surface \"skin\": front color sample lies beside the picture at 87 % of its length");
  draw("", line, color);
  says("beside the picture at 0 %");
  draw(plain_image, line, R"({ sample = "#colors" })");
  says("did you mean \"colours\"?");
  draw(plain_image, line, R"("#102030")");
  says("no colour of it is sampled");
}

// ---- The project's own ----

TEST(OwnSketches, HaveTheColoursOfTheirPictures) {
  const fs::path templates = fs::path(POMONA_SOURCE_DIR) / "templates";
  int sampled = 0;
  for (const auto& entry : fs::directory_iterator(templates)) {
    const std::string bytes = entry.path().extension() == ".toml" ? bytes_of(entry.path()) : "";
    if (bytes.find("sample = ") == std::string::npos) continue;
    const std::string name = entry.path().stem().string();
    const TemporaryFolder folder;
    for (const char* kind : {".toml", ".svg"}) fs::copy(templates / (name + kind), folder / (name + kind));
    fs::copy(templates / "textures", folder / "textures");
    EXPECT_EQ(run_pomona({"sketch", name + ".toml", "--sample", "--quiet"}, folder.path()).status, 0) << name;
    EXPECT_EQ(bytes_of(folder / (name + ".toml")), bytes) << name;
    ++sampled;
  }
  EXPECT_GE(sampled, 2);
}

TEST(OwnSketches, NameWhoseTheirPicturesAre) {
  const fs::path templates = fs::path(POMONA_SOURCE_DIR) / "templates";
  const std::string credits = bytes_of(templates / "CREDITS");
  for (const auto& entry : fs::directory_iterator(templates)) {
    if (entry.path().extension() != ".svg" || bytes_of(entry.path()).find("<image") == std::string::npos) continue;
    EXPECT_THAT(credits, HasSubstr(entry.path().filename().string()));
    EXPECT_LT(fs::file_size(entry.path()), 150000u) << entry.path();
  }
}

}  // namespace
}  // namespace pomona::testing
