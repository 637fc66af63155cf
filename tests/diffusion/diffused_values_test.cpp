// Four values diffused at once equal colours, channel by channel.
#include "generator/diffusion/pmvc/diffused_values.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "tests/shapes/seeded_fruit.h"

namespace pomona {
namespace {

std::vector<glm::vec4> random_values(std::size_t count) {
  const RandomStream stream({7, 0}, "values");
  std::vector<glm::vec4> values;
  for (std::uint64_t v = 0; v < count; ++v) {
    glm::vec4 value(0);
    for (std::uint64_t k = 0; k < 4; ++k) value[static_cast<int>(k)] = static_cast<float>(stream.uniform(4 * v + k));
    values.push_back(value);
  }
  return values;
}

/// Channel `k` of the values as a grey colour, diffused as colours are.
std::vector<Color> as_grey(DiffusionSurfaces surfaces, const std::vector<glm::vec4>& values, int k,
                           const std::vector<glm::vec3>& points) {
  for (std::size_t v = 0; v < values.size(); ++v)
    surfaces.front_color[v] = surfaces.back_color[v] = Color(values[v][k]);
  return make_pmvc_diffuser({Quality::draft, {}})->diffuse(surfaces, points).color;
}

TEST(DiffusedValues, AreWhatColoursWouldBeToTheBit) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  // Points inside, on a surface, and where the outside of the skin is nearest.
  std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(200);
  points.push_back(fruit.position[fruit.triangle.front().x]);
  points.emplace_back(10, 10, 10);
  const std::vector<glm::vec4> values = random_values(fruit.vertex_count());
  const std::vector<glm::vec4> found = diffused_values(fruit, values, points);
  ASSERT_EQ(found.size(), points.size());
  for (int k = 0; k < 4; ++k) {
    const std::vector<Color> expected = as_grey(fruit, values, k, points);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i][k], expected[i].r) << i << " " << k;
  }
}

/// As guides of two cuts are asked: in planes or out of them, with many others or few.
TEST(DiffusedValues, DependOnTheirPointAlone) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(300);
  const std::vector<glm::vec4> values = random_values(fruit.vertex_count());
  const std::vector<glm::vec4> together = diffused_values(fruit, values, points);
  for (const std::size_t step : {std::size_t{3}, std::size_t{60}, points.size() - 1}) {
    std::vector<glm::vec3> some;
    for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
    some.emplace_back(0.001f, 0.002f, 0.003f);
    const std::vector<glm::vec4> apart = diffused_values(fruit, values, some);
    for (std::size_t i = 0; i < points.size(); i += step) EXPECT_EQ(apart[i / step], together[i]) << step << " " << i;
  }
}

TEST(DiffusedValues, DoNotDependOnThreads) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(100);
  const std::vector<glm::vec4> values = random_values(fruit.vertex_count());
  EXPECT_EQ(diffused_values(fruit, values, points, {1}), diffused_values(fruit, values, points, {3}));
}

}  // namespace
}  // namespace pomona
