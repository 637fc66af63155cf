// A plate of several figures: boxes, numbers, legend.
#include "render/picture/plate_sheet.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "render/picture/paper.h"
#include "render/style/style_file.h"

namespace pomona {
namespace {

constexpr int width = 600, height = 750;

/// A red disc that fills its box on bare paper; its upper and lower half are two parts.
SheetFigure disc(const PlateBox& room, const Color& paper, std::vector<std::string> names) {
  const int w = static_cast<int>(room.high.x - room.low.x), h = static_cast<int>(room.high.y - room.low.y);
  SheetFigure figure{{w, h, {}}, {w, h, {}, std::move(names)}, 1000};
  const int r = std::min(w, h) / 2 - 2;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const bool inside = (x - w / 2) * (x - w / 2) + (y - h / 2) * (y - h / 2) < r * r;
      figure.picture.pixels.push_back(inside ? glm::u8vec3(200, 30, 30) : to_srgb8(paper));
      figure.parts.part.push_back(!inside ? -1 : y < h / 2 ? 0 : 1);
    }
  }
  return figure;
}

class Sheet : public ::testing::Test {
 protected:
  Sheet() { style_.vignette = 0.05; }

  PlateSheet sheet(int figures) const {
    return PlateSheet(style_, {"Tomato", "Solanum lycopersicum"}, {"skin", "gel", "flesh", "seed"}, figures, width,
                      height);
  }
  Image drawn(int figures) const {
    const PlateSheet made = sheet(figures);
    std::vector<SheetFigure> all;
    for (const PlateBox& room : made.rooms()) all.push_back(disc(room, style_.paper, {"skin", "gel"}));
    return made.drawn(all);
  }

  Style style_ = style_named("plate");
};

TEST_F(Sheet, GivesEachFigureARoomOfItsOwn) {
  for (const int figures : {1, 2, 3, 4}) {
    const std::vector<PlateBox> rooms = sheet(figures).rooms();
    ASSERT_EQ(rooms.size(), static_cast<std::size_t>(figures));
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      EXPECT_GT(rooms[i].high.x - rooms[i].low.x, 0.25 * width / (figures > 1 ? 2 : 1)) << i;
      EXPECT_GT(rooms[i].low.x, 0) << i;
      EXPECT_LT(rooms[i].high.y, height) << i;
      for (std::size_t k = 0; k < i; ++k) {
        const bool apart = rooms[k].high.x <= rooms[i].low.x || rooms[k].high.y <= rooms[i].low.y;
        EXPECT_TRUE(apart) << k << " and " << i;
      }
    }
  }
}

TEST_F(Sheet, ShowsTheFiguresAsTheyAreAndPaperAroundThem) {
  const Image image = drawn(4);
  const Paper paper(style_, width, height);
  const PlateSheet made = sheet(4);
  for (const PlateBox& room : made.rooms()) {
    const glm::ivec2 middle((room.low + room.high) * 0.5);
    // In the middle of the box the paper has hardly browned; only few pixels of lines and dots may be there.
    int red = 0;
    for (int dy = -10; dy <= 10; ++dy) {
      for (int dx = -10; dx <= 10; ++dx) {
        const glm::u8vec3 pixel = image.at(middle.x + dx, middle.y + dy);
        if (pixel.r > 150 && pixel.g < 80) ++red;
      }
    }
    EXPECT_GT(red, 380);
  }
  EXPECT_EQ(image.at(3, 3), to_srgb8(paper.at(3, 3)));
}

/// A shadow wider than its box ends softly on the paper, and the fruit does not fade.
TEST_F(Sheet, LetsShadowsFadeBeforeTheyAreCutOff) {
  style_.plate->labels = style_.plate->scale_bar = false;
  const PlateSheet made = sheet(4);
  std::vector<SheetFigure> all;
  for (const PlateBox& room : made.rooms()) {
    all.push_back(disc(room, style_.paper, {"skin", "gel"}));
    for (std::size_t i = 0; i < all.back().parts.part.size(); ++i) {
      if (all.back().parts.part[i] < 0) all.back().picture.pixels[i] = to_srgb8(0.7f * style_.paper);
    }
  }
  const Image image = made.drawn(all);
  const Paper paper(style_, width, height);
  const auto darker = [&](int x, int y) { return int{to_srgb8(paper.at(x, y)).g} - int{image.at(x, y).g}; };
  for (const PlateBox& room : made.rooms()) {
    const glm::ivec2 low(room.low), high(room.high), middle = (low + high) / 2;
    const int r = std::min(high.x - low.x, high.y - low.y) / 2 - 6;
    for (int y = low.y; y < high.y; ++y) {
      if (std::abs(y - middle.y) < r / 2) continue;  // too close to the fruit
      EXPECT_LE(darker(low.x, y), 2) << "at the room's left edge";
      EXPECT_LE(darker(high.x - 1, y), 2) << "at its right edge";
    }
    EXPECT_GT(darker(low.x + (high.x - low.x) / 5, low.y + (high.y - low.y) / 5), 25) << "a shadow all the same";
    EXPECT_LT(image.at(middle.x, middle.y - r).g, 80) << "the fruit, almost at the edge";
  }
}

/// The same parts in four figures have one number each: the ink of one figure's labels, plus letters and bars.
TEST_F(Sheet, NumbersEachPartOnce) {
  const auto dark = [](const Image& image) {
    return std::count_if(image.pixels.begin(), image.pixels.end(),
                         [](const glm::u8vec3& p) { return p.r < 110 && p.g < 90; });
  };
  Style without = style_;
  without.plate->labels = false;
  const PlateSheet bare(without, {"Tomato", "Solanum lycopersicum"}, {"skin", "gel", "flesh", "seed"}, 4, width,
                        height);
  const PlateSheet full = sheet(4);
  std::vector<SheetFigure> one, four;
  for (std::size_t i = 0; i < 4; ++i) {
    four.push_back(disc(full.rooms()[i], style_.paper, {"skin", "gel"}));
    one.push_back(four.back());
    if (i > 0) one.back().parts = {};
  }
  EXPECT_EQ(dark(full.drawn(one)), dark(full.drawn(four)));
  std::vector<SheetFigure> unnamed;
  for (const PlateBox& room : bare.rooms()) unnamed.push_back(disc(room, style_.paper, {"skin", "gel"}));
  EXPECT_GT(dark(full.drawn(four)), dark(bare.drawn(unnamed)));
}

TEST_F(Sheet, IsTheSameEveryTime) { EXPECT_EQ(drawn(4).pixels, drawn(4).pixels); }

}  // namespace
}  // namespace pomona
