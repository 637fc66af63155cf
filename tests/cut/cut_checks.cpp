#include "tests/cut/cut_checks.h"

#include <gtest/gtest.h>

#include "tests/shapes/shapes.h"

namespace pomona::shapes {

double volume_of(const Cut& cut) {
  double sum = 0;
  for (const CutPiece& piece : cut.pieces) sum += piece.volume;
  return sum;
}

void expect_whole(const Cut& cut, double whole_volume) {
  for (std::size_t i = 0; i < cut.pieces.size(); ++i) EXPECT_TRUE(cut.pieces[i].closed) << "piece " << i;
  EXPECT_NEAR(volume_of(cut) / whole_volume, 1, 1e-6);
}

void expect_same(const Cut& first, const Cut& second) {
  EXPECT_EQ(first.section.position, second.section.position);
  EXPECT_EQ(first.section.triangle, second.section.triangle);
  EXPECT_EQ(first.section.normal, second.section.normal);
  EXPECT_EQ(first.section.color, second.section.color);
  ASSERT_EQ(first.pieces.size(), second.pieces.size());
  for (std::size_t i = 0; i < first.pieces.size(); ++i) {
    EXPECT_EQ(first.pieces[i].position, second.pieces[i].position);
    EXPECT_EQ(first.pieces[i].triangle, second.pieces[i].triangle);
  }
}

std::vector<DiffusionSurfaces> fruits_to_cut() {
  return {
      sphere(0.05, 5, skin_paint()),
      torus(0.04, 0.015, 16, 9),
      box({-0.03, 0, -0.02}, {0.03, 0.05, 0.04}, 3, skin_paint()),
      tilted(nested_spheres(0.05, 0.02, 5)),
      hollow_ball(0.05, 0.044, 5),
      joined(torus(0.04, 0.015, 16, 9), moved(torus(0.04, 0.015, 16, 9), {0.013, 0.007, 0})),
  };
}

}  // namespace pomona::shapes
