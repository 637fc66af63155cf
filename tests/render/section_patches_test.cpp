// A section's colours as patches: they cover the faces and have their colours.
#include "render/picture/section_patches.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render/picture/section_picture.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

double area(const std::array<glm::dvec2, 3>& corner) {
  const glm::dvec2 a = corner[1] - corner[0], b = corner[2] - corner[0];
  return 0.5 * std::abs(a.x * b.y - a.y * b.x);
}

double area_of_faces(const CrossSection& section, const std::vector<PlacedFace>& faces) {
  double sum = 0;
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    const PlacedFace& face = faces[section.cut[t]];
    const glm::uvec3 v = section.triangle[t];
    sum += area({face.to_paper(section.position[v.x]), face.to_paper(section.position[v.y]),
                 face.to_paper(section.position[v.z])});
  }
  return sum;
}

class Patches : public ::testing::Test {
 protected:
  std::vector<SectionPatch> patches(const PatchOptions& options) const {
    return section_patches(section_, faces_, look_, style_, options);
  }

  /// True within three pixels of a disc's rim, where pixels may also show paper.
  bool near_rim(const glm::dvec2& place) const {
    return std::none_of(faces_.begin(), faces_.end(), [&](const PlacedFace& face) {
      const glm::dvec2 half = (face.high - face.low) * (0.5 * face.scale);
      return glm::length(place - face.corner - half) < half.x - 3;
    });
  }

  CrossSection section_ = testing::disc_section(2);
  std::vector<PlacedFace> faces_ = lay_out(section_, {320, 240}, 10);
  Style style_ = style_named("ink");
  Look look_{testing::some_noise({0.6f, 0.02f, 0.02f})};
};

TEST_F(Patches, CoverTheFaces) {
  double sum = 0;
  for (const SectionPatch& patch : patches({.width = 320, .height = 240})) sum += area(patch.corner);
  EXPECT_NEAR(sum / area_of_faces(section_, faces_), 1, 1e-9);
}

TEST_F(Patches, AreTheSameForAnyNumberOfThreads) {
  const auto told = [&](int threads) {
    std::vector<double> numbers;
    for (const SectionPatch& patch : patches({.width = 320, .height = 240, .threads = {threads}})) {
      numbers.insert(numbers.end(), {patch.corner[0].x, patch.corner[2].y, static_cast<double>(patch.color.r)});
    }
    return numbers;
  };
  EXPECT_EQ(told(1), told(2));
}

/// The picture of the section has the patch's colour at the patch's middle, apart from its smoothing within a pixel.
TEST_F(Patches, HaveThePicturesColors) {
  const SectionPictureOptions options{.width = 320, .height = 240};
  const Image picture = paint_faces(section_, faces_, look_, InkStyle{}, style_, options);
  std::size_t seen = 0;
  double off = 0;
  glm::dvec3 bias(0);
  for (const SectionPatch& patch : patches({.width = 320, .height = 240})) {
    if (area(patch.corner) < 2) continue;
    const glm::dvec2 middle = (patch.corner[0] + patch.corner[1] + patch.corner[2]) / 3.0;
    if (near_rim(middle)) continue;
    const glm::dvec3 there(picture.at(static_cast<int>(middle.x), static_cast<int>(middle.y)));
    const glm::dvec3 less = glm::dvec3(patch.color) - there;
    off += std::max({std::abs(less.x), std::abs(less.y), std::abs(less.z)});
    bias += less;
    ++seen;
  }
  ASSERT_GT(seen, 500u);
  const auto all = static_cast<double>(seen);
  EXPECT_LT(off / all, 7);
  for (int channel = 0; channel < 3; ++channel) EXPECT_LT(std::abs(bias[channel]) / all, 3.5) << channel;
}

TEST_F(Patches, AreFinerWhereLessMayDiffer) {
  EXPECT_GT(patches({.width = 320, .height = 240, .tolerance = 3}).size(),
            patches({.width = 320, .height = 240, .tolerance = 30}).size());
}

}  // namespace
}  // namespace pomona
