// Meshes of modelling tools as solids.
#include "generator/scene/mesh_solid.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace pomona {
namespace {

/// A cone, one metre tall over a circle of 10 cm, of `sides` triangles around its tip, with its base.
PlainMesh cone(std::uint32_t sides) {
  PlainMesh mesh;
  mesh.position = {{0, 1, 0}, {0, 0, 0}};
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    mesh.position.emplace_back(0.1 * std::cos(angle), 0, 0.1 * std::sin(angle));
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % sides;
    mesh.triangle.insert(mesh.triangle.end(), {{0, b, a}, {1, a, b}});
  }
  return mesh;
}

TEST(MeshSolid, KeepsSharpEdgesAndRoundsOthers) {
  const Solid solid = mesh_solid(cone(32), "cone");
  EXPECT_TRUE(solid.closed);
  EXPECT_NEAR(solid.volume, M_PI * 0.01 / 3, 1e-4);

  // The rim has a vertex for the base and one for the wall, whose normal is that of the round cone.
  ASSERT_EQ(solid.mesh.triangle.size(), 64u);
  for (const glm::uvec3& t : solid.mesh.triangle) {
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 p = solid.mesh.position[t[k]], n = solid.mesh.normal[t[k]];
      if (p.y > 0.5f) continue;
      const glm::vec3 out(p.x, 0, p.z);
      const glm::vec3 wall = glm::normalize(10.0f * out + glm::vec3(0, 0.1f, 0));
      EXPECT_TRUE(n.y < -0.999f || glm::length(n - wall) < 0.01f) << n.x << " " << n.y << " " << n.z;
    }
  }
}

/// Only front faces of closed meshes are drawn, and a file may have them inside out.
TEST(MeshSolid, TurnsWhatIsInsideOut) {
  PlainMesh inside_out = cone(32);
  for (glm::uvec3& t : inside_out.triangle) std::swap(t.y, t.z);
  const Solid solid = mesh_solid(inside_out, "cone");
  EXPECT_TRUE(solid.closed);
  double six_volumes = 0;
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const glm::dvec3 a(solid.mesh.position[t.x]), b(solid.mesh.position[t.y]), c(solid.mesh.position[t.z]);
    six_volumes += glm::dot(a, glm::cross(b, c));
    for (int k = 0; k < 3; ++k) EXPECT_GT(glm::dot(glm::dvec3(solid.mesh.normal[t[k]]), glm::cross(b - a, c - a)), 0);
  }
  EXPECT_NEAR(six_volumes / 6, solid.volume, 1e-9);
}

/// Comparing all triangles at a tip with each other would take quadratic time: half an hour here.
TEST(MeshSolid, TakesTipsOfVeryManyTriangles) {
  const std::uint32_t sides = 400'000;
  const Solid solid = mesh_solid(cone(sides), "cone");
  EXPECT_TRUE(solid.closed);
  EXPECT_EQ(solid.mesh.triangle.size(), 2 * sides);
  for (const glm::vec3& n : solid.mesh.normal) ASSERT_NEAR(glm::length(n), 1, 1e-5);
}

}  // namespace
}  // namespace pomona
