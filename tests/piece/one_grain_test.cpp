// One seed of a fruit, by itself and made round.
#include "generator/piece/one_grain.h"

#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/mesh/connected_vertices.h"
#include "generator/piece/smoothed.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

Template shipped(const std::string& name) {
  return read_template(std::filesystem::path(POMONA_SOURCE_DIR) / "templates" / (name + ".toml"));
}

std::optional<Solid> seed_of(const std::string& name) {
  const Template fruit = shipped(name);
  return one_grain(grow(fruit, {}, {.as_drawn = true}), fruit, name);
}

/// Six times the enclosed volume; positive if triangles face outwards.
double six_volumes(const Solid& solid) {
  double sum = 0;
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const glm::dvec3 a(solid.mesh.position[t.x]), b(solid.mesh.position[t.y]), c(solid.mesh.position[t.z]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum;
}

bool is_closed(const Solid& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const glm::uvec3& t : solid.mesh.triangle) {
    ++edges[{t.x, t.y}], ++edges[{t.y, t.z}], ++edges[{t.z, t.x}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return true;
}

TEST(OneGrain, IsOneClosedSeedOfItsFruit) {
  for (const std::string name : {"tomato", "kiwi"}) {
    const std::optional<Solid> seed = seed_of(name);
    ASSERT_TRUE(seed) << name;
    EXPECT_TRUE(is_closed(*seed)) << name;
    EXPECT_GT(six_volumes(*seed), 0) << name;
    DisjointSets sets = connected_vertices(seed->mesh.position.size(), seed->mesh.triangle);
    for (std::uint32_t v = 0; v < seed->mesh.position.size(); ++v) EXPECT_EQ(sets.root(v), 0u) << name;
    for (const std::int32_t part : seed->mesh.part)
      EXPECT_EQ(seed->look->part_names[static_cast<std::size_t>(part)], "seed") << name;
  }
}

TEST(OneGrain, IsNoRootAndNoStone) {
  EXPECT_FALSE(seed_of("onion"));    // the grains of an onion are roots
  EXPECT_FALSE(seed_of("avocado"));  // an avocado's stone is a surface
}

TEST(OneGrain, BecomesRoundWithoutOpening) {
  const Solid seed = seed_of("tomato").value(), round = smoothed(seed, 2);
  EXPECT_EQ(round.mesh.triangle.size(), 16 * seed.mesh.triangle.size());
  EXPECT_TRUE(is_closed(round));

  // The corners stay, and the surface between them swells, by less than a coarse ball is smaller than a ball.
  for (std::size_t v = 0; v < seed.mesh.position.size(); ++v) EXPECT_EQ(round.mesh.position[v], seed.mesh.position[v]);
  EXPECT_GT(six_volumes(round), six_volumes(seed));
  EXPECT_LT(six_volumes(round), 1.5 * six_volumes(seed));
  for (const glm::vec3& n : round.mesh.normal) EXPECT_NEAR(glm::length(n), 1, 1e-5);
}

}  // namespace
}  // namespace pomona
