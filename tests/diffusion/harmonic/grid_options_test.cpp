#include "generator/diffusion/harmonic/grid_options.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

double cells_in_box(const DiffusionSurfaces& surfaces, const HarmonicOptions& options) {
  const glm::dvec3 size = bounds_of(surfaces).size() / grid_options(surfaces, options).spacing;
  return size.x * size.y * size.z;
}

TEST(GridOptions, GiveBoxesOfAnyShapeTheSameNumberOfCells) {
  for (const glm::dvec3& size : {glm::dvec3(1), glm::dvec3(2, 1, 0.5), glm::dvec3(0.04, 0.07, 0.05)}) {
    const DiffusionSurfaces box = shapes::box(glm::dvec3(0.01), glm::dvec3(0.01) + size);
    EXPECT_NEAR(cells_in_box(box, {.nodes = 40}) / 64000, 1, 1e-5);
    EXPECT_NEAR(cells_in_box(box, {.quality = Quality::final}) / (112. * 112 * 112), 1, 1e-5);
  }
}

TEST(GridOptions, WorkHarderForBetterQuality) {
  const DiffusionSurfaces ball = shapes::sphere(1, 3);
  const GridOptions draft = grid_options(ball, {.quality = Quality::draft});
  const GridOptions final = grid_options(ball, {.quality = Quality::final});
  const GridOptions reference = grid_options(ball, {.quality = Quality::reference});
  EXPECT_GT(draft.spacing, final.spacing);
  EXPECT_GT(final.spacing, reference.spacing);
  EXPECT_GT(reference.cycles, final.cycles);
  EXPECT_EQ(draft.refine_above, 0) << "no patches but around small bodies";
  EXPECT_EQ(final.refine_above, 0);
  EXPECT_GT(reference.refine_above, 0);
}

TEST(GridOptions, TakeWhatIsAskedFor) {
  const GridOptions options = grid_options(
      shapes::sphere(1, 3),
      {.threads = {3}, .nodes = 20, .cycles = 7, .finer = 1, .refine_above = 0.25, .shift = {0.1, 0.2, 0.3}});
  EXPECT_NEAR(options.spacing, 0.1, 1e-6);
  EXPECT_EQ(options.cycles, 7);
  EXPECT_EQ(options.finer, 1);
  EXPECT_EQ(options.refine_above, 0.25);
  EXPECT_EQ(options.shift, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(options.threads.count, 3);
  EXPECT_EQ(grid_options(shapes::sphere(1, 3), {}).finer, 2) << "as needed";
  EXPECT_EQ(grid_options(shapes::sphere(1, 3), {.quality = Quality::reference, .refine_above = 0}).refine_above, 0);
}

/// However long or flat the surfaces are, and with the widest margin, a lattice's rows can be stored.
TEST(GridOptions, StayWithinWhatALatticeCanCount) {
  for (const glm::dvec3& size : {glm::dvec3(1, 1e-3, 1e-3), glm::dvec3(1, 1, 0), glm::dvec3(1)}) {
    const DiffusionSurfaces thin = shapes::box(glm::dvec3(0), size);
    const GridOptions options = grid_options(thin, {.nodes = 100'000});
    const int margin = static_cast<int>(0.25 / options.spacing);
    const Lattice lattice = lattice_around(thin, options.spacing, margin, 4, glm::dvec3(0.9));
    for (const int count : lattice.count) EXPECT_LE(count, max_nodes);
    EXPECT_GT(1 / options.spacing, 0.99 * max_cells);
  }
}

}  // namespace
}  // namespace pomona
