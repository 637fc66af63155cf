// One mesh in the colours of another ripeness.
#include "generator/piece/recolored.h"

#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

TEST(Recolored, SkinHasTheOtherFruitsColoursAtItsPlacesAndNothingElseChanges) {
  const DiffusionSurfaces own = shapes::seeded_fruit();
  DiffusionSurfaces other = own;
  for (Color& color : other.front_color) color = Color(1) - color;
  for (Color& color : other.back_color) color = Color(1) - color;
  const std::vector<Solid> pieces = shapes::sliced(own, {parse_knife("half")}).pieces;
  ASSERT_EQ(pieces.size(), 2u);
  const Solid piece = recolored(pieces[0], own, other);
  EXPECT_EQ(piece.position, pieces[0].position);
  std::size_t skin = 0;
  for (std::size_t t = 0; t < piece.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = piece.triangle[t][k];
      if (piece.cut_face[t] >= 0) continue;
      ++skin;
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(piece.color[v][channel], 1 - pieces[0].color[v][channel], 2e-3);
    }
  }
  EXPECT_GT(skin, 1000u);
  const Solid same = recolored(pieces[0], own, own);
  for (std::size_t v = 0; v < same.color.size(); ++v)
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(same.color[v][channel], pieces[0].color[v][channel], 2e-3);
}

TEST(Recolored, RefusesAnotherFruit) {
  const DiffusionSurfaces own = shapes::seeded_fruit();
  DiffusionSurfaces other = own;
  other.position[0].x += 0.001f;
  EXPECT_THROW(recolored(Solid{}, own, other), Error);
}

}  // namespace
}  // namespace pomona
