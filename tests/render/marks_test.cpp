// Tones by marks: how much paper they cover, their directions, and what they avoid.
#include "render/marks/marks.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/marks/blur.h"
#include "render/marks/flow_field.h"
#include "render/marks/hatching.h"
#include "render/marks/solid_spots.h"
#include "render/marks/stippling.h"
#include "render/marks/tone_map.h"
#include "render/picture/marks_on_picture.h"

namespace pomona {
namespace {

constexpr int side = 200;

ToneMap even(double darkness) { return {side, side, std::vector<float>(side * side, static_cast<float>(darkness))}; }

/// The share of the sheet's inner part that marks cover.
double covered(const std::vector<Mark>& marks) {
  InkLayer layer(side, side);
  for (const Mark& mark : marks) layer.draw(stroke_of(mark));
  double sum = 0;
  for (int y = 20; y < side - 20; ++y) {
    for (int x = 20; x < side - 20; ++x) sum += layer.at(x, y);
  }
  return sum / ((side - 40) * (side - 40));
}

FlowField all_along(const glm::vec2& direction) { return {side, side, std::vector<glm::vec2>(side * side, direction)}; }

/// Waves of grey whose crests run along (along.x, along.y), 25 pixels from crest to crest times `larger`.
Image waves(const glm::dvec2& along, int larger = 1) {
  Image image{side * larger, side * larger, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double across = 0.25 * (along.x * y - along.y * x) / larger;
      image.pixels.emplace_back(glm::u8vec3(static_cast<std::uint8_t>(128 + 100 * std::sin(across))));
    }
  }
  return image;
}

TEST(Marks, BlurKeepsEvenFieldsAndTheirSum) {
  for (const float value : blurred(std::vector<float>(60 * 40, 0.3f), 60, 40, 4)) EXPECT_NEAR(value, 0.3f, 1e-6);

  std::vector<float> dot(61 * 61, 0.0f);
  dot[30 * 61 + 30] = 1;
  const std::vector<float> wide = blurred(dot, 61, 61, 4);
  double sum = 0, second = 0;
  for (int y = 0; y < 61; ++y) {
    for (int x = 0; x < 61; ++x) {
      sum += wide[y * 61 + x];
      second += static_cast<double>(wide[y * 61 + x]) * (x - 30) * (x - 30);
    }
  }
  EXPECT_NEAR(sum, 1, 1e-5);
  EXPECT_NEAR(std::sqrt(second), 4, 0.5);
}

TEST(Marks, DotsCoverTheShareThatTheToneAsksFor) {
  for (const double dark : {0.1, 0.25, 0.5}) EXPECT_NEAR(covered(stippled(even(dark))), dark, 0.04) << dark;
}

TEST(Marks, DotsKeepTheirDistance) {
  const std::vector<Mark> dots = stippled(even(0.3), {.width = 3});
  const double closest = 1.48 * 1.5 / std::sqrt(0.3);
  ASSERT_GT(dots.size(), 500u);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_GE(glm::length(dots[i][0].at - dots[k][0].at), closest - 1e-9) << i << " and " << k;
    }
  }
}

TEST(Marks, BarePaperStaysBare) {
  EXPECT_TRUE(stippled(even(0)).empty());
  EXPECT_TRUE(hatched(even(0), all_along({1, 0})).empty());

  // Paper with its grain, otherwise empty.
  Image paper{side, side, {}};
  for (int i = 0; i < side * side; ++i) paper.pixels.emplace_back(glm::u8vec3(static_cast<std::uint8_t>(240 + i % 5)));
  const Color color = from_srgb8({243, 243, 243});
  EXPECT_TRUE(marks_of(paper, color, {.kind = MarkKind::hatching}).empty());
  EXPECT_TRUE(marks_of(paper, color, {.kind = MarkKind::stipple}).empty());
}

TEST(Marks, FlowRunsAlongEdges) {
  for (const glm::dvec2& along : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(0.6, 0.8), glm::dvec2(0.8, -0.6)}) {
    const FlowField flow = flow_of(waves(along));
    for (int y = 30; y < side - 30; y += 7) {
      for (int x = 30; x < side - 30; x += 7) {
        const glm::dvec2 way = flow.at({x, y}, along);
        EXPECT_NEAR(glm::length(way), 1, 1e-5);
        EXPECT_GT(glm::dot(way, along), 0.995) << x << " " << y << " along " << along.x << " " << along.y;
      }
    }
  }
}

/// Waves that are twenty times as large flow the same way, compared in squares.
TEST(Marks, FlowOfALargePictureIsThatOfASmallOne) {
  const glm::dvec2 along(0.6, 0.8);
  const Image large = waves(along, 20);
  const FlowField flow = flow_of(large, {.scale = 120});
  EXPECT_LE(flow.width, 1600);
  for (int y = 600; y < 3400; y += 401) {
    for (int x = 600; x < 3400; x += 401) EXPECT_GT(glm::dot(flow.at({x, y}, along), along), 0.99) << x << " " << y;
  }
}

TEST(Marks, LinesFollowTheFlowAndKeepTheirDistance) {
  const HatchOptions options{.spacing = 6, .width = 4};
  const std::vector<Mark> lines = hatched(even(0.4), all_along({0.6f, 0.8f}), options);
  ASSERT_GT(lines.size(), 20u);
  for (const Mark& line : lines) {
    ASSERT_GT(line.size(), 1u);
    const glm::dvec2 way = line.back().at - line.front().at;
    EXPECT_GT(std::abs(glm::dot(way, glm::dvec2(0.6, 0.8))) / glm::length(way), 0.999);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (const MarkPoint& a : lines[i]) {
        for (const MarkPoint& b : lines[k]) {
          ASSERT_GE(glm::length(a.at - b.at), 0.5 * options.spacing) << i << " and " << k;
        }
      }
    }
  }
}

/// In small pictures a step is longer than half a spacing, and the bend is that from one step to the next.
TEST(Marks, LinesOfSmallPicturesRunOn) {
  const std::vector<Mark> lines = hatched(even(0.4), all_along({1, 0}), {.spacing = 1.5, .width = 1});
  ASSERT_GT(lines.size(), 100u);
  for (const Mark& line : lines) EXPECT_GT(std::abs(line.back().at.x - line.front().at.x), side - 3.0);
}

TEST(Marks, DarkerTonesCoverMore) {
  double before = 0;
  for (const double dark : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double share = covered(hatched(even(dark), all_along({1, 0}), {.spacing = 6, .width = 4}));
    EXPECT_GT(share, before + 0.02) << dark;
    before = share;
  }
}

TEST(Marks, CrossingLinesStandInTheDarkAlone) {
  const auto crossing = [](double dark) {
    const std::vector<Mark> lines = hatched(even(dark), all_along({1, 0}));
    return std::any_of(lines.begin(), lines.end(),
                       [](const Mark& line) { return std::abs(line.back().at.y - line.front().at.y) > 5; });
  };
  EXPECT_FALSE(crossing(0.5));
  EXPECT_TRUE(crossing(0.9));
}

/// Seeds are solid; what is large, or hardly darker than what is around, is left to the other marks.
TEST(Marks, SmallDarkThingsAreFilled) {
  const auto with_disc = [](double radius, double darkness) {
    ToneMap tones = even(0.45);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x)
        if (std::hypot(x - 99.5, y - 99.5) < radius) tones.darkness[y * side + x] = static_cast<float>(darkness);
    }
    return tones;
  };
  const std::vector<Mark> marks = solid_spots(with_disc(7, 1), {.around = 24, .longest = 50});
  InkLayer layer(side, side);
  for (const Mark& mark : marks) layer.draw(stroke_of(mark));
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double from_middle = std::hypot(x - 99.5, y - 99.5);
      const double inked = layer.at(x, y);
      EXPECT_TRUE(from_middle >= 6 || inked > 0.9) << x << " " << y << " " << inked;
      EXPECT_TRUE(from_middle <= 9 || inked < 0.01) << x << " " << y << " " << inked;
    }
  }
  EXPECT_TRUE(solid_spots(with_disc(40, 1), {.around = 24, .longest = 50}).empty());
  EXPECT_TRUE(solid_spots(with_disc(7, 0.55), {.around = 24, .longest = 50}).empty());
  EXPECT_TRUE(solid_spots(even(1), {.around = 24, .longest = 50}).empty());
}

TEST(Marks, PaleFruitIsDrawnWithAsMuchContrastAsDarkFruit) {
  // A disc of one of two greys: its tone is full ink in both cases.
  for (const int grey : {60, 190}) {
    Image image{side, side, {}};
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const bool inside = (x - 100) * (x - 100) + (y - 100) * (y - 100) < 60 * 60;
        image.pixels.emplace_back(glm::u8vec3(static_cast<std::uint8_t>(inside ? grey : 250)));
      }
    }
    const ToneMap tones = tones_of(image, from_srgb8({250, 250, 250}));
    EXPECT_GT(tones.at({100, 100}), 0.95) << grey;
    EXPECT_EQ(tones.at({10, 10}), 0) << grey;
    EXPECT_EQ(tones.at({-5, 10}), 0);
  }
}

TEST(Marks, AllPaintOfAFullWashStaysBelowTheMarks) {
  const Image painted = waves({1, 0});
  const Style style;
  const Paper paper(style, side, side);
  EXPECT_EQ(with_marks(painted, paper, {}, {.wash = 1}, Color(0)).pixels, painted.pixels);
  EXPECT_EQ(with_marks(painted, paper, {}, {.wash = 0}, Color(0)).at(50, 50), to_srgb8(paper.at(50, 50)));
}

}  // namespace
}  // namespace pomona
