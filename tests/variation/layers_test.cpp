// The conditions that keep layers around the axis apart.
#include "generator/variation/layers.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/variation/fruits.h"

namespace pomona {
namespace {

/// A vertical curve through these points, with the loop of an onion's skin.
SurfaceSketch layer(std::vector<glm::dvec2> vertical, int along) {
  SurfaceSketch sketch = fruits::onion(1).surfaces.front();
  sketch.vertical.points = std::move(vertical);
  sketch.along = along;
  return sketch;
}

TEST(LayerGap, BetweenLayersThatCrossAsDrawnIsNoneWhicheverWayTheyAreDrawn) {
  // A funnel that rises outside and falls to the axis, and a short slope that crosses only the falling part.
  const std::vector<glm::dvec2> funnel{{0.03, -0.01}, {0.03, 0.04}, {0, 0}}, slope{{0.005, 0.011}, {0.02, 0.009}};
  for (const bool is_turned : {false, true}) {
    for (const bool slope_is_turned : {false, true}) {
      std::vector<glm::dvec2> a = funnel, b = slope;
      if (is_turned) std::reverse(a.begin(), a.end());
      if (slope_is_turned) std::reverse(b.begin(), b.end());
      const SurfaceSketch long_one = layer(a, 3), short_one = layer(b, 2);  // each with its number of drawn points
      for (const LayerGap& gap : {LayerGap(long_one, short_one), LayerGap(short_one, long_one)}) {
        EXPECT_EQ(gap.room(1).low, SwellRange{}.low) << is_turned << slope_is_turned;
        EXPECT_EQ(gap.room(1).high, SwellRange{}.high) << is_turned << slope_is_turned;
      }
    }
  }
}

TEST(LayerGap, KeepsEitherLayerOffTheOtherByAsMuch) {
  // One of the two is rounder towards its top, which reduces its swell there.
  Template onion = fruits::onion(2);
  onion.surfaces[1].roundness = Ramp<double>{{{0.0, 0.0}, {1.0, 0.8}}};
  const LayerGap outer(onion.surfaces[0], onion.surfaces[1]), inner(onion.surfaces[1], onion.surfaces[0]);
  for (const double swell : {0.7, 0.9, 1.0, 1.1, 1.4}) {
    EXPECT_NEAR(outer.room(swell).low, inner.inverted().room(swell).low, 1e-9) << swell;
    EXPECT_NEAR(inner.room(swell).high, outer.inverted().room(swell).high, 1e-9) << swell;
    EXPECT_GT(outer.room(swell).low, 0);
    EXPECT_LT(inner.room(swell).high, 2);
  }
}

TEST(KeptApart, ALayerWithoutRoomLiesInTheMiddleOfWhatItsNeighboursWant) {
  // The outermost layer shrinks and the innermost grows, until there is no room for the one between them.
  const Layers layers = layers_of(fruits::onion(3));
  const std::vector<double> outer(64, 0.8), inner(64, 1.2), as_drawn(64, 1.0);
  const double highest = layers.gap[1][0].room(0.8).high, lowest = layers.gap[1][2].room(1.2).low;
  ASSERT_GT(lowest, highest);
  const auto apart = kept_apart(layers, {outer, as_drawn, inner}, {true, false, true});
  for (const double swell : apart[1]) EXPECT_NEAR(swell, 0.5 * (lowest + highest), 1e-12);
  EXPECT_EQ(apart[0], outer);
  EXPECT_EQ(apart[2], inner);
}

}  // namespace
}  // namespace pomona
