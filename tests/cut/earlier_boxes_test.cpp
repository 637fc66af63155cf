#include "generator/cut/unite/earlier_boxes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

TEST(EarlierBoxes, AreAllOfEarlierLayersThatMeet) {
  // Corners on a coarse grid, so that many boxes just touch.
  const RandomStream random({}, "tests/earlier boxes");
  std::vector<Box<float>> box;
  std::vector<int> layer;
  for (std::uint64_t n = 0; n < 300; ++n) {
    glm::vec3 low(0), size(0);
    for (int axis = 0; axis < 3; ++axis) {
      const auto draw = 7 * n + static_cast<std::uint64_t>(axis);
      low[axis] = static_cast<float>(random.below(draw, 14));
      size[axis] = static_cast<float>(random.below(draw + 3, 4));
    }
    box.push_back({low, low + size});
    layer.push_back(static_cast<int>(random.below(7 * n + 6, 5)) - 1);  // a fifth is of no layer
  }

  const EarlierBoxes earlier(box, layer);
  std::size_t all = 0;
  for (std::uint32_t i = 0; i < box.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < box.size(); ++k) {
      const bool before = layer[k] != EarlierBoxes::no_layer && layer[k] < layer[i];
      if (before && box[k].meets(box[i])) expected.push_back(k);
    }
    std::vector<std::uint32_t> found(earlier.of(i).begin(), earlier.of(i).end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    all += found.size();
  }
  EXPECT_GT(all, 300u);
}

}  // namespace
}  // namespace pomona
