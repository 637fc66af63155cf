#include "generator/diffusion/harmonic/refinement_indicator.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "generator/diffusion/harmonic/multigrid.h"
#include "generator/diffusion/harmonic/patches.h"
#include "generator/diffusion/harmonic/solve_field.h"
#include "tests/diffusion/fields.h"
#include "tests/diffusion/harmonic/whole_shapes.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

GridLevel solved_grid(const DiffusionSurfaces& surfaces) {
  const GridOptions options{.spacing = 0.1, .shift = glm::dvec3(0.3, 0.1, 0.7), .reach = 1e-5, .threads = {2}};
  std::vector<GridLevel> levels =
      solved(prepared_field(surfaces, options).levels, {.cycles = 12, .threads = options.threads});
  return std::move(levels.front());
}

TEST(Bends, AreNoneWhereColoursAreLinear) {
  const auto linear = [](const glm::dvec3& p) { return glm::dvec3(0.5 + 0.2 * p.x, 0.5 - 0.1 * p.y + 0.1 * p.z, 0.4); };
  const GridLevel grid = solved_grid(fields::painted_with(shapes::tilted(fields::linear_scene()), linear));
  for (const float indicator : indicator_of_bricks(grid, 2e-5, {2})) EXPECT_EQ(indicator, 0);
}

/// Around a small ball the field falls like 1 / r: at nodes about a cell away, the indicator is about h^2 / r^2 times
/// the ball's colour.
TEST(Bends, LieAroundWhatIsSmall) {
  const GridLevel grid = solved_grid(shapes::nested_spheres(1, 0.2, 8));
  const std::vector<float> indicator = indicator_of_bricks(grid, 0.02, {2});
  const Node count = bricks_of(grid.lattice);
  std::size_t bent = 0;
  for (int z = 0; z < count[2]; ++z) {
    for (int y = 0; y < count[1]; ++y) {
      for (int x = 0; x < count[0]; ++x) {
        if (indicator[brick_index({x, y, z}, count)] == 0) continue;
        ++bent;
        const Node middle{brick[0] * x + brick[0] / 2, brick[1] * y + brick[1] / 2, brick[2] * z + brick[2] / 2};
        EXPECT_LT(glm::length(shapes::place_of(grid.lattice, middle)), 0.7);
      }
    }
  }
  EXPECT_GT(bent, 10u);
  EXPECT_EQ(indicator, indicator_of_bricks(grid, 0.02, {1}));
}

TEST(Bends, AreTakenFromTheLargestOn) {
  const std::vector<float> indicator = {0, 0.5f, 0.1f, 0.4f, 0, 0.4f, 0.2f};
  const auto marks = [&](std::size_t max) { return bricks_to_refine(indicator, max); };
  using Marks = std::vector<std::uint8_t>;
  EXPECT_EQ(marks(9), (Marks{0, 1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(marks(5), (Marks{0, 1, 1, 1, 0, 1, 1}));
  EXPECT_EQ(marks(4), (Marks{0, 1, 0, 1, 0, 1, 1}));
  EXPECT_EQ(marks(2), (Marks{0, 1, 0, 0, 0, 0, 0})) << "of those that bend alike all or none";
  EXPECT_EQ(marks(0), (Marks{0, 0, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace pomona
