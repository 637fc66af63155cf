// The benchmarks' baseline: cube maps drawn by OpenGL agree with the reference.
#include "bench/baselines/cube_maps.h"

#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona::bench {
namespace {

TEST(CubeMaps, AgreeWithTheReference) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(60);
  const std::vector<Color> truth = make_pmvc_diffuser({Quality::reference, {}})->diffuse(fruit, points).color;
  const CubeMapColors maps = cube_map_pmvc(fruit, points);
  const fields::Errors errors = fields::errors_of(maps.color, truth);
  EXPECT_LE(errors.rms, 0.3);
  EXPECT_LE(errors.max, 1);
  EXPECT_GT(maps.per_point, 0);
  EXPECT_FALSE(maps.renderer.empty());
}

TEST(CubeMaps, ShellHasTheValuesOfItsExactIntegral) {
  shapes::Paint inner, outer;
  inner.front = inner.back = Color(1);
  outer.front = outer.back = Color(0);
  const DiffusionSurfaces shell = joined(shapes::sphere(0.4, 32, inner), shapes::sphere(1, 32, outer));
  const std::vector<glm::vec3> points{{0, 0.5f, 0}, {0, 0.7f, 0}, {0.9f, 0, 0}, {0.4041f, 0.4041f, 0.4041f}};
  const std::vector<double> exact{0.576000, 0.136582, 0.025501, 0.136582};
  const std::vector<Color> colors = cube_map_pmvc(shell, points).color;
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(colors[i].x, exact[i], 1e-3) << i;
}

TEST(CubeMaps, BothSidesAndPointsOnThem) {
  shapes::Paint paint, far;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  paint.front_hidden = true;
  far.front = far.back = Color(0, 0, 1);
  const DiffusionSurfaces scene =
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 3, paint), shapes::box({-3, -3, -3}, {3, 3, 3}, 1, far));
  const std::vector<glm::vec3> points{{0.3f, 1, 0.2f},     {0.3f, 0.99998f, 0.2f}, {0.3f, 1.01f, 0.2f},
                                      {0.3f, 0.99f, 0.2f}, {-1.01f, 0.3f, 0.2f},   {0.3f, 0.2f, -0.99f}};
  const std::vector<Color> colors = cube_map_pmvc(scene, points).color;
  EXPECT_EQ(colors[0], paint.front);
  EXPECT_EQ(colors[1], paint.back);
  EXPECT_NEAR(colors[2].r, 1, 0.04);
  EXPECT_NEAR(colors[3].g, 1, 0.04);
  EXPECT_NEAR(colors[4].r, 1, 0.04);
  EXPECT_NEAR(colors[5].g, 1, 0.04);
  EXPECT_TRUE(cube_map_pmvc(scene, {}).color.empty());
  EXPECT_THROW(cube_map_pmvc(DiffusionSurfaces{}, points), Error);
}

}  // namespace
}  // namespace pomona::bench
