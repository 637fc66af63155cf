#include "generator/mesh/overlapping_boxes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/mesh/random_points.h"

namespace pomona {
namespace {

/// Boxes of all sizes, with corners on a coarse grid, so that many just touch.
template <typename T>
std::vector<Box<T>> random_boxes(std::size_t count, std::uint64_t seed) {
  const std::vector<glm::dvec3> middles = random_points(count, 20, seed), sizes = random_points(count, 4, seed + 1);
  std::vector<Box<T>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec<3, T> middle(glm::floor(middles[i])), half(glm::floor(glm::abs(sizes[i])));
    boxes.push_back({middle - half, middle + half});
  }
  return boxes;
}

std::vector<BoxPair> sorted(std::vector<BoxPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(OverlappingBoxes, AreAllThatMeetEachOnce) {
  for (const std::size_t count : {0, 1, 2, 7, 8, 9, 300}) {
    const std::vector<Box<float>> boxes = random_boxes<float>(count, 2);
    std::vector<BoxPair> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[i].meets(boxes[j])) expected.emplace_back(i, j);
      }
    }
    EXPECT_EQ(sorted(overlapping_boxes(boxes)), expected);

    // The search ends with the first visit that asks for it.
    std::size_t visits = 0;
    visit_overlapping_boxes(boxes, [&](std::uint32_t, std::uint32_t) { return ++visits < 5; });
    EXPECT_EQ(visits, std::min<std::size_t>(5, expected.size()));
  }
}

TEST(OverlappingBoxes, OfTwoSortsAreAllThatMeetEachOnce) {
  for (const std::size_t count : {0, 1, 8, 9, 200}) {
    const std::vector<Box<double>> one = random_boxes<double>(count, 4), other = random_boxes<double>(70, 6);
    std::vector<BoxPair> expected;
    for (std::uint32_t i = 0; i < one.size(); ++i) {
      for (std::uint32_t j = 0; j < other.size(); ++j) {
        if (one[i].meets(other[j])) expected.emplace_back(i, j);
      }
    }
    EXPECT_EQ(sorted(overlapping_boxes(one, other)), expected);
  }
}

TEST(OverlappingBoxes, AreFoundInOnePlace) {
  const Box<float> box{glm::vec3(1), glm::vec3(1)};
  EXPECT_EQ(overlapping_boxes(std::vector<Box<float>>(20, box)).size(), 190u)
      << "boxes without a size, all at one point";
}

}  // namespace
}  // namespace pomona
