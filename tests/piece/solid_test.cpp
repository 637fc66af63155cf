// Solids: pieces with their cut faces, ready to be drawn and exported.
#include "generator/piece/solid.h"

#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/knife/parse_knife.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

std::vector<Solid> cut_ball(const std::vector<std::string>& knives) {
  std::vector<Knife> parsed;
  for (const std::string& k : knives) parsed.push_back(parse_knife(k));
  return shapes::sliced(shapes::tilted(shapes::nested_spheres(0.05, 0.02, 8)), parsed).pieces;
}

TEST(Solids, FaceAirAndCloseAndHaveNormalsAlongTheirTriangles) {
  for (const Solid& solid : cut_ball({"half", "across"})) {
    using Place = std::tuple<float, float, float>;
    std::map<std::pair<Place, Place>, int> edges;
    double volume = 0;
    for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      glm::dvec3 p[3], smooth(0);
      for (int i = 0; i < 3; ++i) {
        p[i] = glm::dvec3(solid.mesh.position[solid.mesh.triangle[t][i]]);
        smooth += glm::dvec3(solid.mesh.normal[solid.mesh.triangle[t][i]]);
      }
      volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
      const glm::dvec3 flat = glm::cross(p[1] - p[0], p[2] - p[0]);
      if (glm::length(flat) > 1e-10) {
        EXPECT_GT(glm::dot(flat, smooth), 0);
      }
      for (int i = 0; i < 3; ++i) {
        const Place a(p[i].x, p[i].y, p[i].z), b(p[(i + 1) % 3].x, p[(i + 1) % 3].y, p[(i + 1) % 3].z);
        edges[std::minmax(a, b)] += a < b ? 1 : -1;
      }
      EXPECT_EQ(solid.mesh.cut_face[t] < 0, solid.mesh.surface[t] >= 0);
    }
    EXPECT_NEAR(volume, solid.volume, 1e-6 * solid.volume);
    for (const auto& [edge, balance] : edges) EXPECT_EQ(balance, 0);
  }
}

TEST(Solids, AreNamedAfterTheirFruit) {
  EXPECT_EQ(cut_ball({})[0].name, "fruit");
  const std::vector<Solid> halves = cut_ball({"half"});
  EXPECT_EQ(halves[0].name, "fruit.piece-1");
  EXPECT_EQ(halves[1].name, "fruit.piece-2");
}

TEST(Solids, OfOneFruitShareItsLookUntilOneGetsItsOwn) {
  std::vector<Solid> quarters = cut_ball({"half", "across"});
  ASSERT_EQ(quarters.size(), 4u);
  for (const Solid& piece : quarters) EXPECT_EQ(piece.look, quarters[0].look) << "one look, not equal ones";
  const double width = quarters[0].look->ink.width;
  quarters[1].own_look().ink.width = 2 * width + 1;
  EXPECT_EQ(quarters[1].look->ink.width, 2 * width + 1);
  EXPECT_EQ(quarters[1].look->part_names, quarters[0].look->part_names);
  for (const std::size_t other : {0, 2, 3}) EXPECT_EQ(quarters[other].look->ink.width, width);
}

TEST(SolidMesh, KnowsItsTriangles) {
  SolidMesh mesh;
  mesh.position = {{9, 9, 9}, {1, 0, 0}, {4, 0, 0}, {1, 2, 0}};
  mesh.triangle = {{0, 1, 2}, {1, 2, 3}};
  EXPECT_EQ(mesh.corners(1)[2], glm::dvec3(1, 2, 0));
  EXPECT_EQ(mesh.area_vector(1), glm::dvec3(0, 0, 6)) << "twice the area, to where it runs counter-clockwise";
  EXPECT_EQ(mesh.place(1, {0, 1, 0}), glm::dvec3(4, 0, 0));
  EXPECT_EQ(mesh.place(1, {0.5, 0.25, 0.25}), glm::dvec3(1.75, 0.5, 0));
}

}  // namespace
}  // namespace pomona
