#include "render/picture/section_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <utility>

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/cut/cut.h"
#include "render/image/png.h"
#include "render/picture/inked_pixels.h"
#include "render/picture/section_ink.h"
#include "render/picture/section_layout.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

Image drawn_disc(const std::string& style, int faces, int threads, int width = 320, int height = 240) {
  return draw_section(testing::disc_section(faces), testing::some_noise({0.6f, 0.02f, 0.02f}), InkStyle{},
                      style_named(style), {.width = width, .height = height, .threads = {threads}});
}

int brightness(const glm::u8vec3& c) { return c.r + c.g + c.b; }

TEST(SectionPicture, ShowsWhatIsThere) {
  const Image image = drawn_disc("plain", 1, 1);
  EXPECT_EQ(image.at(2, 2), to_srgb8(style_named("plain").paper));
  const glm::u8vec3 flesh = image.at(160, 29);
  EXPECT_GT(flesh.r, 180);
  EXPECT_LT(flesh.g, 60);
}

TEST(SectionPicture, InksTheRim) {
  const Image image = drawn_disc("ink", 1, 1, 640, 480);
  int darkest = 765;
  for (int x = 0; x < 320; ++x) darkest = std::min(darkest, brightness(image.at(x, 240)));
  EXPECT_LT(darkest, 150);
  EXPECT_GT(brightness(image.at(1, 240)), 600);
}

/// The facets are one unrolled face with a rim of the same length.
TEST(SectionPicture, InksNoLineBetweenTheFacetsOfAStroke) {
  const Knife knife{PlaneCut(StrokeKnife{{{-0.05, 0.02}, {0, 0.03}, {0.05, 0.02}}})};
  const DiffusionSurfaces box = shapes::box({-0.03, 0, -0.02}, {0.03, 0.05, 0.04}, 3, shapes::skin_paint());
  const CrossSection section = cut(box, std::vector<Knife>{knife}).section;
  const std::vector<PlacedFace> faces = lay_out(section, {400, 300}, 10);
  const std::vector<SectionLine> lines = section_lines(section, faces);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].rim);
  EXPECT_TRUE(lines[0].line.closed);
  const std::vector<glm::dvec2>& points = lines[0].line.points;
  double around = glm::distance(points.back(), points.front());
  for (std::size_t i = 1; i < points.size(); ++i) around += glm::distance(points[i - 1], points[i]);
  const double length = 2 * std::hypot(0.03, 0.006);
  EXPECT_NEAR(around / faces[0].scale, 2 * (length + 0.06), 1e-3);
}

TEST(SectionPicture, IsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(drawn_disc("ink", 5, 1).pixels, drawn_disc("ink", 5, 2).pixels);
  EXPECT_EQ(write_png(drawn_disc("ink", 5, 1)), write_png(drawn_disc("ink", 5, 2)));
}

TEST(SectionPicture, LaysSeveralFacesOutWithoutOverlap) {
  // Equal discs: the red area is the number of discs times that of one, and grows with the square of the scale.
  const auto fruit_pixels = [](const Image& image) {
    return std::count_if(image.pixels.begin(), image.pixels.end(), [](const glm::u8vec3& c) { return c.g < 120; });
  };
  const auto twelve = static_cast<double>(fruit_pixels(drawn_disc("plain", 12, 2, 800, 600)));
  EXPECT_GT(twelve, 0.3 * 800 * 600);
  EXPECT_LT(twelve, 0.8 * 800 * 600);
}

TEST(SectionPicture, LeavesNoCracksBetweenTriangles) {
  // Along a row from the centre to the skin no pixel may show the paper.
  const Image image = drawn_disc("plain", 1, 1);
  for (int x = 160; x < 160 + 95; ++x) EXPECT_LT(brightness(image.at(x, 120)), 620) << x;
}

TEST(SectionPicture, KeepsPaperForAnEmptySection) {
  const Image image = draw_section({}, {}, {}, style_named("plain"), {.width = 8, .height = 8});
  for (const glm::u8vec3& pixel : image.pixels) EXPECT_EQ(pixel, to_srgb8(style_named("plain").paper));
}

TEST(SectionPicture, RefusesSizesThatCannotBe) {
  EXPECT_THROW(draw_section({}, {}, {}, style_named("plain"), {.width = 0, .height = 8}), Error);
  EXPECT_THROW(draw_section({}, {}, {}, style_named("plain"), {.width = 8, .height = 1 << 20}), Error);
}

TEST(Png, ComesBackAsItWas) {
  const Image image = drawn_disc("ink", 2, 1);
  const Image back = read_png(write_png(image), "x.png");
  EXPECT_EQ(back.width, image.width);
  EXPECT_EQ(back.pixels, image.pixels);
}

/// A section's picture is drawn in bands: no seam may show between bands, and rows count from the picture's top.
TEST(InkedPixels, AreTheSameWhateverRowsAreAskedFor) {
  const StrokePoint a{{3.3, 2.1}, 1.7, 1}, b{{17.9, 36.4}, 2.9, 0.5};
  std::map<std::pair<int, int>, int> whole, in_bands;
  for_inked_pixels(a, b, 20, {0, 40}, [&](int x, int y, int hits) { whole[{x, y}] = hits; });
  for (int from = 0; from < 40; from += 7) {
    for_inked_pixels(a, b, 20, {from, std::min(40, from + 7)},
                     [&](int x, int y, int hits) { EXPECT_TRUE(in_bands.emplace(std::pair(x, y), hits).second); });
  }
  EXPECT_GT(whole.size(), 100u);
  EXPECT_EQ(in_bands, whole);
}

std::string message_of_png(const std::string& bytes) {
  try {
    read_png(bytes, "x.png");
  } catch (const Error& error) {
    return error.what();
  }
  return "was read";
}

TEST(Png, SaysWhereItEndsTooEarly) {
  const std::string bytes = write_png(drawn_disc("plain", 1, 1, 64, 64));
  EXPECT_THAT(message_of_png(bytes.substr(0, 20)), ::testing::StartsWith("x.png:byte 1"));
  EXPECT_THAT(message_of_png(bytes.substr(0, 20)), ::testing::HasSubstr("it ends too early"));
}

/// The CRC-32 of a PNG chunk.
std::uint32_t png_checksum(const std::string& chunk) {
  std::uint32_t sum = 0xffffffffu;
  for (const char c : chunk) {
    sum ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) sum = (sum >> 1) ^ ((sum & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~sum;
}

/// The header of a picture with 9000 x 9000 pixels.
TEST(Png, ThatCannotHoldItsPixelsIsRefusedBeforeTheyAreSetAside) {
  std::string bytes = write_png(drawn_disc("plain", 1, 1, 64, 64));
  bytes.replace(16, 8, std::string("\0\0\x23\x28\0\0\x23\x28", 8));
  const std::uint32_t checksum = png_checksum(bytes.substr(12, 17));
  for (int k = 0; k < 4; ++k) bytes[29 + k] = static_cast<char>(checksum >> (24 - 8 * k));
  EXPECT_THAT(message_of_png(bytes), ::testing::HasSubstr("more pixels than its bytes can hold"));
}

TEST(Png, RefusesWhatIsNotOne) {
  std::string bytes = write_png(drawn_disc("plain", 1, 1, 64, 64));
  EXPECT_THROW(read_png("no picture", "x.png"), Error);
  EXPECT_THROW(read_png(bytes.substr(0, bytes.size() / 2), "x.png"), Error);
  EXPECT_THROW(read_png("", "x.png"), Error);
}

}  // namespace
}  // namespace pomona
