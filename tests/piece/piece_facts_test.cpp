// Facts about pieces, and pieces moved apart.
#include "generator/piece/piece_facts.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "generator/knife/parse_knife.h"
#include "generator/piece/facts_json.h"
#include "generator/scene/explode.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

/// A box of 2 x 1 x 1 cm in eight dice.
Scene dice() {
  const DiffusionSurfaces box = shapes::box({0, 0, 0}, {0.02, 0.01, 0.01}, 2, shapes::skin_paint());
  return gathered(shapes::sliced(box, {parse_knife("dice:2")}).pieces);
}

TEST(PieceFacts, OfADie) {
  const Scene scene = dice();
  ASSERT_EQ(scene.solids.size(), 8u);
  const PieceFacts facts = facts_of(scene.solids[0]);
  EXPECT_NEAR(facts.volume, 0.01 * 0.005 * 0.005, 1e-13);
  EXPECT_NEAR(facts.mass, scene.solids[0].density * facts.volume, 1e-12);
  EXPECT_LT(glm::distance(facts.center, glm::dvec3(0.005, 0.0025, 0.0025)), 1e-9);
  EXPECT_LT(glm::distance(facts.low, glm::dvec3(0)), 1e-9);
  EXPECT_LT(glm::distance(facts.high, glm::dvec3(0.01, 0.005, 0.005)), 1e-9);
  EXPECT_EQ(facts.triangles, scene.solids[0].mesh.triangle.size());
}

/// The piece list and the extras of a .glb both take the mass from the solid.
TEST(PieceFacts, MassIsByTheTemplatesDensity) {
  const DiffusionSurfaces box = shapes::box({0, 0, 0}, {0.02, 0.01, 0.01}, 2, shapes::skin_paint());
  Template dense;
  dense.density = 840;
  const std::vector<Solid> pieces = shapes::sliced(box, {}, dense).pieces;
  EXPECT_NEAR(facts_of(pieces.at(0)).mass, 840 * 2e-6, 1e-9);
}

/// The inertia about the centre, as a matrix: row by row.
TEST(PieceFacts, AreToldWithAllRowsOfTheInertia) {
  const Solid die = dice().solids[3];
  const PieceFacts facts = facts_of(die);
  const nlohmann::ordered_json told = facts_json(die);
  ASSERT_EQ(told["inertia"].size(), 3u);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(told["inertia"][i][k].get<double>(), facts.inertia[i][k], 1e-6 * facts.inertia[0][0]);
    EXPECT_NEAR(told["center"][i].get<double>(), facts.center[i], 1e-6);
  }
  // A block of 10 x 5 x 5 mm has its min inertia about its length, and equal ones about the two other axes.
  EXPECT_LT(told["inertia"][0][0], told["inertia"][1][1]);
  EXPECT_NEAR(told["inertia"][1][1].get<double>(), told["inertia"][2][2].get<double>(), 1e-6 * facts.inertia[1][1]);
  EXPECT_EQ(told["closed"], true);
}

TEST(PieceFacts, TellInstancesWhereATemplatePlacesOthers) {
  Solid die = dice().solids[3];
  EXPECT_FALSE(facts_json(die).contains("instances"));
  die.instances = {0, 3, 17};
  EXPECT_EQ(facts_json(die)["instances"].dump(), "[0,3,17]");
}

TEST(PieceFacts, OfNothing) {
  const PieceFacts facts = facts_of({});
  EXPECT_EQ(facts.triangles, 0u);
  EXPECT_EQ(facts.mass, 0);
}

TEST(Explode, MovesPiecesApartByTheFactor) {
  const Scene together = dice(), apart = exploded(together, 1.5);
  const glm::dvec3 middle(0.01, 0.005, 0.005);
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 before = facts_of(together.solids[i]).center;
    const glm::dvec3 after = before + apart.instances[i].pose.translation;
    EXPECT_LT(glm::distance(after - middle, 1.5 * (before - middle)), 1e-9);
  }
  EXPECT_EQ(exploded(together, 1).instances[3].pose.translation, glm::dvec3(0));
}

}  // namespace
}  // namespace pomona
