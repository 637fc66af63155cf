// Properties of plates: letters, places of labels, the length of the bar.
#include "render/plate/plate.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "render/lettering/coverage.h"
#include "render/lettering/typeface.h"
#include "render/picture/section_picture.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

/// Rings of parts around a core with seeds in it, in a box of the picture.
PartMap rings(int width, int height, const PlateBox& box, int parts) {
  PartMap map{width, height, std::vector<std::int32_t>(static_cast<std::size_t>(width) * height, -1), {}};
  for (int i = 0; i < parts; ++i) map.names.push_back("part_" + std::to_string(i));
  const glm::dvec2 center = 0.5 * (box.low + box.high);
  const double radius = 0.5 * std::min(box.high.x - box.low.x, box.high.y - box.low.y);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double r = glm::distance(glm::dvec2(x + 0.5, y + 0.5), center) / radius;
      if (r < 1) map.part[static_cast<std::size_t>(y) * width + x] = static_cast<std::int32_t>(parts * r);
    }
  }
  return map;
}

bool overlap(const PlateBox& a, const PlateBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

struct Sheet {
  int width, height, parts;
};

class PlateLabels : public ::testing::TestWithParam<Sheet> {};

TEST_P(PlateLabels, NameEveryPartOnceInsideThePictureWithoutOverlapOrCrossing) {
  const auto [width, height, parts] = GetParam();
  std::vector<std::string> names;
  for (int i = 0; i < parts; ++i) names.push_back("part_" + std::to_string(i));
  const Plate plate(style_named("plate"), {"Onion", "Allium cepa"}, names, width, height);
  const PartMap map = rings(width, height, plate.figure(), parts);
  const std::vector<Label> labels = plate.labels(map);

  std::set<std::int32_t> named;
  for (const Label& label : labels) {
    EXPECT_TRUE(named.insert(label.part).second) << label.text;
    EXPECT_EQ(map.at(static_cast<int>(label.tip.x), static_cast<int>(label.tip.y)), label.part);
    EXPECT_GE(label.bounds.low.x, 0);
    EXPECT_GE(label.bounds.low.y, 0);
    EXPECT_LE(label.bounds.high.x, width);
    EXPECT_LE(label.bounds.high.y, height);
    for (const Label& other : labels) {
      if (&label == &other) continue;
      EXPECT_FALSE(overlap(label.bounds, other.bounds)) << label.text << ", " << other.text;
      EXPECT_FALSE(leaders_cross(label, other)) << label.text << ", " << other.text;
    }
  }
  EXPECT_EQ(named.size(), static_cast<std::size_t>(parts));
}

INSTANTIATE_TEST_SUITE_P(Sheets, PlateLabels,
                         ::testing::Values(Sheet{400, 300, 1}, Sheet{400, 300, 5}, Sheet{300, 400, 7},
                                           Sheet{800, 450, 12}, Sheet{600, 600, 15}));

TEST(PlateLabelsOfTooManyParts, LeaveOutTheSmallest) {
  std::vector<std::string> names(60, "x");
  for (int i = 0; i < 60; ++i) names[static_cast<std::size_t>(i)] += std::to_string(i);
  const Plate plate(style_named("plate"), {"", ""}, names, 500, 300);
  const std::vector<Label> labels = plate.labels(rings(500, 300, plate.figure(), 60));
  EXPECT_GT(labels.size(), 5u);
  EXPECT_LT(labels.size(), 60u);
  for (const Label& a : labels) {
    for (const Label& b : labels) {
      if (&a != &b) {
        EXPECT_FALSE(overlap(a.bounds, b.bounds));
      }
    }
  }
}

TEST(ShownParts, AreThoseThatAreLargeAndThickEnough) {
  PartMap map{20, 10, std::vector<std::int32_t>(200, 0), {"flesh", "skin", "flesh", "none"}};
  for (int x = 0; x < 20; ++x) map.part[static_cast<std::size_t>(x)] = 1;  // one pixel thick
  map.part[105] = 2;                                                       // bears the name of part 0
  const std::vector<ShownPart> parts = shown_parts(map, 0.01, 1.5);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].part, 0);
  EXPECT_EQ(parts[0].area, 180);
  EXPECT_EQ(shown_parts(map, 0.01, 0.5).size(), 2u);
  EXPECT_TRUE(shown_parts({4, 4, std::vector<std::int32_t>(16, -1), {"x"}}, 0, 0).empty());
}

/// A ring of rings whose outermost is `skin` pixels thick.
PartMap in_skin(int width, int height, const PlateBox& box, double skin) {
  PartMap map = rings(width, height, box, 3);
  const glm::dvec2 center = 0.5 * (box.low + box.high);
  const double radius = 0.5 * std::min(box.high.x - box.low.x, box.high.y - box.low.y);
  map.names.push_back("thin_skin");
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double inwards = radius - glm::distance(glm::dvec2(x + 0.5, y + 0.5), center);
      if (inwards >= 0 && inwards < skin) map.part[static_cast<std::size_t>(y) * width + x] = 3;
    }
  }
  return map;
}

TEST(PlateLabelsOfAThinSkin, PointAtItFromOutside) {
  for (const double skin : {0.7, 1.0, 1.6}) {
    const Plate plate(style_named("plate"), {"Onion", ""}, {"part_0", "part_1", "part_2", "thin_skin"}, 800, 800);
    const PartMap map = in_skin(800, 800, plate.figure(), skin);
    int found = 0;
    for (const Label& label : plate.labels(map)) {
      if (label.text != "thin skin") continue;
      ++found;
      EXPECT_EQ(map.at(static_cast<int>(label.tip.x), static_cast<int>(label.tip.y)), 3);
      // There is paper all the way to the tip.
      const double length = glm::distance(label.leader, label.tip);
      for (double s = 0; s + 2 < length; s += 0.5) {
        const glm::dvec2 p = label.leader + (label.tip - label.leader) * (s / length);
        EXPECT_EQ(map.at(static_cast<int>(p.x), static_cast<int>(p.y)), -1) << p.x << " " << p.y;
      }
    }
    EXPECT_EQ(found, 1) << skin;
  }
}

TEST(AddRims, NamesTheOutsideOfASurfaceThatNoVertexBears) {
  const CrossSection section = testing::disc_section();
  std::vector<std::string> rim;
  for (const SectionSegment& segment : section.segments) {
    if (segment.boundary) rim.push_back(section.surface_names[segment.surface]);
  }
  ASSERT_FALSE(rim.empty());
  const std::vector<PlacedFace> faces = lay_out(section, {200, 200}, 10);
  PartMap map = section_parts(section, faces, 200, 200);
  const std::vector<std::int32_t> before = map.part;
  add_rims(map, section, faces, {{rim.front(), parts_in(section).front()}});
  EXPECT_EQ(map.part, before) << "that part shows within";
  add_rims(map, section, faces, {{rim.front(), "peel"}});
  EXPECT_EQ(map.names.back(), "peel");
  const auto peel = static_cast<std::int32_t>(map.names.size()) - 1;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (map.part[i] == before[i]) continue;
    ASSERT_EQ(map.part[i], peel);
    const auto beside = [&](std::size_t by) { return before[i - by] < 0 || before[i + by] < 0; };
    EXPECT_TRUE(before[i] < 0 || beside(1) || beside(200) || beside(201) || beside(199)) << i;
  }
  EXPECT_NE(map.part, before);
}

TEST(ShownParts, ThatAreThinWithinAreNotPointedAt) {
  PartMap map{30, 30, std::vector<std::int32_t>(900, -1), {"flesh", "membrane"}};
  for (int y = 5; y < 25; ++y) {
    for (int x = 5; x < 25; ++x) map.part[static_cast<std::size_t>(y) * 30 + x] = x == 15 && y > 5 && y < 24 ? 1 : 0;
  }
  const std::vector<ShownPart> parts = shown_parts(map, 0.001, 1.5);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].part, 0);
}

TEST(ScaleBar, IsRoundAndAsLongAsItSays) {
  const Plate plate(style_named("plate"), {}, {"flesh"}, 800, 600);
  const double room = plate.figure().high.x - plate.figure().low.x;
  for (const double scale : {17.0, 400.0, 9000.0, 31000.0, 123456.0, 9e6}) {
    const Plate::ScaleBar bar = plate.scale_bar(scale);
    EXPECT_DOUBLE_EQ(bar.length, bar.metres * scale);
    EXPECT_LE(bar.length, 0.3 * room * (1 + 1e-9));
    EXPECT_GT(bar.length, 0.1 * room);
    const double digits = bar.metres / std::pow(10, std::floor(std::log10(bar.metres * 1.0000001)));
    EXPECT_TRUE(std::fabs(digits - 1) < 1e-9 || std::fabs(digits - 2) < 1e-9 || std::fabs(digits - 5) < 1e-9) << digits;
  }
  EXPECT_EQ(plate.scale_bar(5000).text, "2 cm");
  EXPECT_EQ(plate.scale_bar(1e5).text, "1 mm");
  EXPECT_EQ(plate.scale_bar(50).text, "2 m");
  EXPECT_EQ(plate.scale_bar(0).length, 0);
}

TEST(ScaleBar, IsDrawnAtItsLength) {
  Style style = style_named("plate");
  style.plate->title = style.plate->labels = false;
  const Plate plate(style, {}, {}, 640, 480);
  Image image{640, 480, std::vector<glm::u8vec3>(640 * 480, glm::u8vec3(255))};
  draw(plate.layers({640, 480, std::vector<std::int32_t>(640 * 480, -1), {}}, 4000), image);
  const Plate::ScaleBar bar = plate.scale_bar(4000);

  // The row below the bar only has ink of the ticks: their outer edges are the ends of the bar.
  const int y = static_cast<int>(bar.start.y + 3);
  const auto inked = [&](int x) { return image.at(x, y).g < 250; };
  int first = 0, last = 639;
  while (first < 639 && !inked(first)) ++first;
  while (last > 0 && !inked(last)) --last;
  EXPECT_NEAR(first, std::floor(bar.start.x), 1);
  EXPECT_NEAR(last, std::floor(bar.start.x + bar.length), 1);
}

TEST(Coverage, OfALineIsItsArea) {
  Coverage cover(40, 30);
  cover.fill(line_outline({5.3, 7.7}, {31.1, 19.2}, 2.5));
  double sum = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) sum += cover.at(x, y);
  }
  EXPECT_NEAR(sum, 2.5 * std::hypot(25.8, 11.5), 0.05);
}

TEST(Typeface, SetsWhatItHasAndLeavesBlanksForTheRest) {
  const Typeface italic("italic"), capitals("capitals");
  EXPECT_GT(italic.width("flesh"), 1.5);
  EXPECT_LT(italic.width("flesh"), 3);
  EXPECT_NEAR(italic.width("ab", 0.5) - italic.width("ab"), 0.5, 1e-12);
  EXPECT_LT(capitals.width("AV"), capitals.width("A") + capitals.width("V"));  // kerned
  EXPECT_GT(capitals.width("M"), capitals.width("m"));
  EXPECT_EQ(italic.outline("\xe6\x9e\x9c", {0, 0}, 10).size(), 0u);  // a Chinese fruit
  EXPECT_GT(italic.width("\xff\xc3"), 0);                            // no UTF-8
  EXPECT_GT(italic.outline("\xc3\xa9", {0, 0}, 10).size(), 1u);      // e and its accent
  EXPECT_EQ(italic.width(""), 0);
}

TEST(Plate, OfASectionIsTheSameForAnyNumberOfThreads) {
  const auto drawn = [](int threads) {
    return draw_section(testing::disc_section(2), testing::some_noise({0.6f, 0.02f, 0.02f}), InkStyle{},
                        style_named("plate"),
                        {.width = 300, .height = 240, .text = {"Disc", "Discus rubens"}, .threads = {threads}});
  };
  EXPECT_EQ(drawn(1).pixels, drawn(2).pixels);
}

TEST(Plate, OfNothingIsATitleOnPaper) {
  const Image image = draw_section({}, {}, {}, style_named("plate"), {.width = 64, .height = 64, .text = {"Air", ""}});
  EXPECT_EQ(image.pixels.size(), 64u * 64u);
}

}  // namespace
}  // namespace pomona
