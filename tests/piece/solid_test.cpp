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
    for (std::size_t t = 0; t < solid.triangle.size(); ++t) {
      glm::dvec3 p[3], smooth(0);
      for (int i = 0; i < 3; ++i) {
        p[i] = glm::dvec3(solid.position[solid.triangle[t][i]]);
        smooth += glm::dvec3(solid.normal[solid.triangle[t][i]]);
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
      EXPECT_EQ(solid.cut_face[t] < 0, solid.surface[t] >= 0);
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

}  // namespace
}  // namespace pomona
