// When two pictures count as the same: tests just below and just above every limit of a tolerance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/compare/comparison.h"
#include "render/compare/comparison_page.h"
#include "render/compare/heat_map.h"

namespace pomona {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// 100 x 100 pixels: 0.1 % of them are ten.
TransparentImage grey() {
  return {Image{100, 100, std::vector<glm::u8vec3>(10000, glm::u8vec3(120))}, std::vector<std::uint8_t>(10000, 255)};
}

/// A picture in which `spots` pixels, far apart, differ by `difference` in one channel.
TransparentImage spotted(std::size_t spots, int difference) {
  TransparentImage picture = grey();
  for (std::size_t i = 0; i < spots; ++i) picture.image.pixels[i * 97].b = static_cast<std::uint8_t>(120 + difference);
  return picture;
}

TEST(Comparison, OfEqualPicturesFindsNothing) {
  const Comparison found = compared(grey(), grey(), {});
  EXPECT_TRUE(found.same);
  EXPECT_EQ(found.largest, 0);
  EXPECT_EQ(found.different, 0u);
  EXPECT_EQ(found.flip, 0);
  EXPECT_THAT(found.reasons, IsEmpty());
}

TEST(Comparison, ExactForgivesNotOneStepOfOneChannelOfOnePixel) {
  const Comparison found = compared(grey(), spotted(1, 1), {});
  EXPECT_FALSE(found.same);
  EXPECT_EQ(found.largest, 1);
  EXPECT_EQ(found.different, 1u);
}

TEST(Comparison, CloseForgivesThreeStepsEverywhereButNotFour) {
  Tolerance tolerance = close_tolerance;
  tolerance.flip = 1;
  EXPECT_TRUE(compared(grey(), spotted(100, 3), tolerance).same);
  const Comparison found = compared(grey(), spotted(11, 4), tolerance);
  EXPECT_FALSE(found.same);
  EXPECT_EQ(found.beyond, 11u);
  EXPECT_THAT(found.reasons, ElementsAre(HasSubstr("11 pixels (0.110 %)")));
}

TEST(Comparison, CloseForgivesATenthOfAPercentToDifferMore) {
  EXPECT_TRUE(compared(grey(), spotted(10, 32), close_tolerance).same);
  EXPECT_FALSE(compared(grey(), spotted(11, 32), close_tolerance).same);
}

TEST(Comparison, CloseForgivesNoPixelThatDiffersByMoreThanThirtyTwo) {
  EXPECT_TRUE(compared(grey(), spotted(1, 32), close_tolerance).same);
  const Comparison found = compared(grey(), spotted(1, 33), close_tolerance);
  EXPECT_FALSE(found.same);
  EXPECT_THAT(found.reasons, ElementsAre(HasSubstr("differs by 33 of 255")));
}

TEST(Comparison, CloseLooksAtFlipToo) {
  // Three steps of one channel are within the limits of a pixel, but visible over the whole picture.
  TransparentImage redder = grey();
  for (glm::u8vec3& pixel : redder.image.pixels) pixel.r = 123;
  const Comparison found = compared(grey(), redder, close_tolerance);
  EXPECT_FALSE(found.same);
  EXPECT_THAT(found.reasons, ElementsAre(HasSubstr("mean FLIP")));
}

TEST(Comparison, OfDifferentSizesIsADifference) {
  TransparentImage small = grey();
  small.image = {50, 200, small.image.pixels};
  const Comparison found = compared(grey(), small, close_tolerance);
  EXPECT_FALSE(found.same);
  EXPECT_THAT(found.reasons, ElementsAre(HasSubstr("100x100 and 50x200")));
}

TEST(Comparison, SeesOpacityAndNotWhatItHides) {
  TransparentImage holed = grey();
  holed.opacity[5] = 254;
  EXPECT_FALSE(compared(grey(), holed, {}).same);

  TransparentImage hidden = grey(), other = grey();
  hidden.opacity[5] = other.opacity[5] = 0;
  other.image.pixels[5] = {1, 2, 3};
  EXPECT_TRUE(compared(hidden, other, {}).same);
  EXPECT_EQ(laid_on_white(hidden).pixels[5], glm::u8vec3(255));
}

TEST(HeatMap, GoesFromBlackToPaleYellow) {
  const Image image = heat_map({3, 1, {0.0f, 0.5f, 1.0f}});
  EXPECT_THAT(image.pixels, ElementsAre(glm::u8vec3(0, 0, 4), glm::u8vec3(181, 54, 122), glm::u8vec3(252, 253, 191)));
}

TEST(ComparisonPage, NeedsNoOtherFileAndNamesWhatIsWrong) {
  const TransparentImage reference = grey(), result = spotted(1, 33);
  const Comparison found = compared(reference, result, close_tolerance);
  const std::string page = comparison_page({.title = "a <b> & \"c\"",
                                            .reference_name = "old.png",
                                            .result_name = "new.png",
                                            .reference = reference,
                                            .result = result},
                                           found, close_tolerance);
  EXPECT_THAT(page, HasSubstr("a &lt;b&gt; &amp; &quot;c&quot;"));
  EXPECT_THAT(page, HasSubstr("differs by 33 of 255"));
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, HasSubstr("reference: old.png"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBORw0KGgo"));
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1)) ++pictures;
  EXPECT_EQ(pictures, 4u) << "reference, result with the reference over it, map";
}

}  // namespace
}  // namespace pomona
