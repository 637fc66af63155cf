// The press: neighbours flatten each other and do not cross.
#include "generator/compose/press.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/compose/grow.h"
#include "generator/surface/crossings.h"
#include "generator/template/read/read_template.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

constexpr double radius = 0.01;

/// Two balls whose middles are a radius apart.
class PressedBalls : public testing::Test {
 protected:
  PressedBalls() : ball_(shapes::sphere(radius, 12, shapes::skin_paint())), reach_(ball_, 0, glm::dvec3(0)) {
    bodies_ = {{&reach_, {}}, {&reach_, {.at = {radius, 0, 0}}}};
  }

  DiffusionSurfaces ball_;
  ReachTable reach_;
  std::vector<PressedBody> bodies_;
};

TEST_F(PressedBalls, reach_is_their_radius_in_every_direction) {
  EXPECT_TRUE(reach_.is_closed());
  for (const glm::dvec3& d : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 2, -3), glm::dvec3(-1, 1, 1)})
    EXPECT_NEAR(reach_.along(d), radius, 0.03 * radius);
  EXPECT_FALSE(ReachTable(ball_, 0, {0, 2 * radius, 0}).is_closed()) << "seen from outside";
}

TEST_F(PressedBalls, each_stays_on_its_side_of_the_gap) {
  const PressSketch press{.gap = 0.001, .soft = 0.02};
  const DiffusionSurfaces first = PressCell(press, bodies_, 0, {}).pressed(ball_);
  const DiffusionSurfaces second = PressCell(press, bodies_, 1, {}).pressed(ball_);
  double flattest = 0, least = 1;
  for (std::size_t v = 0; v < first.vertex_count(); ++v) {
    flattest = std::max(flattest, static_cast<double>(first.position[v].x));
    least = std::min(least, static_cast<double>(second.position[v].x) + radius);
  }
  EXPECT_LE(flattest, 0.5 * radius - 0.5 * press.gap + 1e-8);
  EXPECT_GE(least, 0.5 * radius + 0.5 * press.gap - 1e-8);
  EXPECT_GT(flattest, 0.4 * radius) << "and no farther than it must";
}

TEST_F(PressedBalls, what_is_away_from_the_neighbour_keeps_its_place) {
  const DiffusionSurfaces first = PressCell({.soft = 0.02}, bodies_, 0, {}).pressed(ball_);
  for (std::size_t v = 0; v < first.vertex_count(); ++v) {
    if (ball_.position[v].x >= 0) continue;
    EXPECT_NEAR(glm::distance(first.position[v], ball_.position[v]), 0, 1e-8);
  }
}

TEST_F(PressedBalls, layers_keep_their_order) {
  const PressCell cell({.soft = 0.02}, bodies_, 0, {});
  DiffusionSurfaces inner = ball_;
  for (glm::vec3& p : inner.position) p *= 0.9f;
  const DiffusionSurfaces outside = cell.pressed(ball_), inside = cell.pressed(inner);
  for (std::size_t v = 0; v < inside.vertex_count(); ++v)
    EXPECT_LT(glm::length(inside.position[v]), 0.95f * glm::length(outside.position[v]));
}

TEST_F(PressedBalls, hearts_too_near_are_told) {
  bodies_[1].pose.at.x = 0.05 * radius;
  EXPECT_TRUE(PressCell({}, bodies_, 0, {}).is_crowded());
  bodies_[1].pose.at.x = radius;
  EXPECT_FALSE(PressCell({}, bodies_, 0, {}).is_crowded());
}

TEST(Press, skins_of_a_bunch_do_not_cross) {
  Template fruit = read_template(std::filesystem::path(POMONA_SOURCE_DIR) / "tests/compose/placed/bunch.toml");
  fruit.places[0].stalk->depth = 1;  // none is so far away: no stalks, which are rooted in both their ends
  const auto crossings = [&](std::uint64_t seed) {
    return crossing_triangles(grow(variant_of(fruit, {seed, 0}), {seed, 0}).swept).size();
  };
  for (std::uint64_t seed = 1; seed < 6; ++seed) EXPECT_EQ(crossings(seed), 0u) << seed;
  fruit.places[0].press.reset();
  EXPECT_GT(crossings(1), 100u);
}

}  // namespace
}  // namespace pomona
