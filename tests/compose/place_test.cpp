// Templates within a template: keys, numbers, parts and limits of instances.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/compose/grow.h"
#include "generator/surface/bodies.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

Template placed(const std::string& name) {
  return read_template(std::filesystem::path(POMONA_SOURCE_DIR) / "tests/compose/placed" / (name + ".toml"));
}

GrownFruit grown(const Template& fruit, std::uint64_t seed, GrowOptions options = {}) {
  options.as_drawn = seed == 0;
  return grow(variant_of(fruit, {seed, 0}, options), {seed, 0}, options);
}

std::int32_t instances_of(const DiffusionSurfaces& surfaces) {
  return surfaces.instance.empty() ? 0 : *std::max_element(surfaces.instance.begin(), surfaces.instance.end());
}

/// Only one instance, moved to its own middle, to compare shapes.
std::vector<glm::vec3> shape_of(const DiffusionSurfaces& surfaces, std::int32_t instance) {
  std::vector<glm::vec3> shape;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (surfaces.instance_of(t) != instance) continue;
    for (int k = 0; k < 3; ++k) shape.push_back(surfaces.position[surfaces.triangle[t][k]]);
  }
  return shape;
}

/// The farthest two corners of an instance's triangles are from each other along one edge, all summed: no two variants
/// have the same.
double edges_of(const DiffusionSurfaces& surfaces, std::int32_t instance) {
  const std::vector<glm::vec3> shape = shape_of(surfaces, instance);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < shape.size(); ++i) sum += static_cast<double>(glm::distance(shape[i], shape[i + 1]));
  return sum;
}

TEST(Place, a_template_without_places_has_no_instances) {
  const GrownFruit berry = grown(placed("berry"), 3);
  EXPECT_TRUE(berry.swept.instance.empty());
  EXPECT_TRUE(berry.sheets.instance.empty());
}

TEST(Place, every_instance_is_closed_and_is_numbered) {
  const GrownFruit bunch = grown(placed("bunch"), 1);
  const std::int32_t count = instances_of(bunch.swept);
  ASSERT_GT(count, 8);
  EXPECT_EQ(bunch.swept.instance.size(), bunch.swept.triangle_count());
  EXPECT_EQ(bunch.sheets.instance.size(), bunch.sheets.triangle_count());
  EXPECT_EQ(instances_of(bunch.grains), count);
  const Bodies bodies = find_bodies(bunch.sheets);
  EXPECT_TRUE(std::all_of(bodies.bodies.begin(), bodies.bodies.end(), [](const auto& b) { return b.closed; }));
  EXPECT_EQ(bodies.bodies.size(), 1u + 2u * static_cast<std::size_t>(count)) << "the axis, and berries with stalks";
  EXPECT_THAT(bodies.warnings, testing::IsEmpty());
}

TEST(Place, names_of_surfaces_and_parts_are_told_once) {
  const Template fruit = placed("bunch");
  EXPECT_THAT(fruit.parts, testing::ElementsAre("wood", "berry.skin", "berry.flesh", "berry.seed"));
  EXPECT_EQ(fruit.materials[1].gloss, 2);
  EXPECT_THAT(fruit.densities, testing::ElementsAre(1000, 1100, 1100, 1100));
  const GrownFruit bunch = grown(fruit, 1);
  EXPECT_THAT(bunch.swept.surface_names, testing::ElementsAre("axis", "berry.skin", "berry.stalk"));
  EXPECT_THAT(bunch.swept.part_names, testing::ElementsAreArray(fruit.parts));
  EXPECT_THAT(bunch.grains.surface_names, testing::ElementsAre("berry.seeds"));
}

TEST(Place, each_instance_is_an_individual_and_at_seed_0_all_are_as_drawn) {
  Template fruit = placed("bunch");
  fruit.places[0].press.reset();
  fruit.places[0].stalk.reset();
  fruit.places[0].heading = PlaceSketch::Heading::out;
  const GrownFruit varied = grown(fruit, 1), drawn = grown(fruit, 0);
  ASSERT_EQ(instances_of(varied.swept), instances_of(drawn.swept)) << "all variants have as many";
  ASSERT_EQ(varied.swept.triangle_count(), drawn.swept.triangle_count());
  std::set<int> sizes;
  for (std::int32_t i = 1; i <= instances_of(varied.swept); ++i) {
    sizes.insert(static_cast<int>(1e6 * edges_of(varied.swept, i)));
    EXPECT_NEAR(edges_of(drawn.swept, i), edges_of(drawn.swept, 1), 1e-4 * edges_of(drawn.swept, 1));
  }
  EXPECT_EQ(static_cast<std::int32_t>(sizes.size()), instances_of(varied.swept));

  fruit.places[0].individuals = 2;
  const GrownFruit shared = grown(fruit, 1);
  EXPECT_NEAR(edges_of(shared.swept, 1), edges_of(varied.swept, 1), 1e-6 * edges_of(varied.swept, 1));
  EXPECT_NEAR(edges_of(shared.swept, 3), edges_of(shared.swept, 1), 1e-4 * edges_of(shared.swept, 1));
  EXPECT_GT(std::abs(edges_of(shared.swept, 2) - edges_of(shared.swept, 1)), 1e-4 * edges_of(shared.swept, 1));
}

TEST(Place, one_more_place_disturbs_none) {
  Template fruit = placed("bunch");
  const GrownFruit alone = grown(fruit, 5);
  fruit.places.push_back(fruit.places[0]);
  fruit.places[1].name = "other";
  const GrownFruit both = grown(fruit, 5);
  ASSERT_EQ(instances_of(both.swept), 2 * instances_of(alone.swept));
  for (std::size_t v = 0; v < alone.swept.vertex_count(); ++v)
    ASSERT_EQ(alone.swept.position[v], both.swept.position[v]);
}

TEST(Place, threads_do_not_matter) {
  const Template fruit = placed("bunch");
  EXPECT_EQ(grown(fruit, 2, {.threads = {1}}).sheets.position, grown(fruit, 2, {.threads = {3}}).sheets.position);
}

TEST(Place, templates_within_what_is_placed) {
  const GrownFruit bowl = grown(placed("bowl"), 1), bunch = grown(placed("bunch"), 1);
  EXPECT_EQ(instances_of(bowl.swept), 3 * (1 + instances_of(bunch.swept)));
  EXPECT_THAT(bowl.swept.part_names,
              testing::ElementsAre("wood", "bunch.berry.skin", "bunch.berry.flesh", "bunch.berry.seed"));
  EXPECT_THAT(bowl.swept.surface_names, testing::Contains("bunch.berry.skin"));
}

TEST(Place, lengths_grow_with_the_fruit) {
  const Template fruit = placed("bunch");
  const GrownFruit once = grown(fruit, 4), twice = grown(fruit, 4, {.scale = 2});
  ASSERT_EQ(once.swept.vertex_count(), twice.swept.vertex_count());
  for (std::size_t v = 0; v < once.swept.vertex_count(); ++v) {
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(2 * once.swept.position[v][k], twice.swept.position[v][k], 2e-6);
  }
}

/// Else the berries of a small bunch crowd, and those of a large one lie apart.
TEST(Place, instances_are_as_much_larger_as_their_variant) {
  Template fruit = placed("bunch"), berry = *fruit.places[0].placed;
  berry.variation = {};
  fruit.places[0].placed = std::make_shared<const Template>(berry);
  fruit.places[0].press.reset();
  fruit.places[0].stalk.reset();
  fruit.places[0].heading = PlaceSketch::Heading::out;
  fruit.variation.size = 0.3;
  const GrownFruit drawn = grown(fruit, 0), varied = grown(fruit, 3);
  const double by = edges_of(varied.swept, 0) / edges_of(drawn.swept, 0);
  ASSERT_GT(std::abs(by - 1), 0.05) << "the axis of another size";
  EXPECT_NEAR(edges_of(varied.swept, 1), by * edges_of(drawn.swept, 1), 1e-3 * edges_of(drawn.swept, 1));
}

TEST(Place, too_many_are_refused_before_any_is_grown) {
  Template fruit = placed("bunch");
  fruit.laws[0].spacing = Ramp<double>::constant(1e-4);
  try {
    grown(fruit, 1);
    FAIL() << "was grown";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    EXPECT_EQ(error.diagnostics().front().place.line, 22) << "its name";
    EXPECT_THAT(error.diagnostics().front().message, testing::HasSubstr("more than 4096 instances"));
  }
}

}  // namespace
}  // namespace pomona
