// Meshes that face inwards, or partly so, are turned outwards like a solid, or reported.
#include "generator/surface/orientation.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/surface/bodies.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/template.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using ::testing::HasSubstr;

/// The faces of a cube about a place, outwards, numbered behind `before` vertices; those listed are left out or turned.
struct Cube {
  double half = 1;
  glm::dvec3 at{0};
  bool inwards = false;
  std::vector<int> turned = {}, left_out = {};
};

std::string obj_of(const std::vector<Cube>& cubes) {
  std::string text;
  int before = 0;
  for (const Cube& cube : cubes) {
    for (int v = 0; v < 8; ++v) {
      const glm::dvec3 p = cube.at + cube.half * glm::dvec3(v & 1 ? 1 : -1, v & 2 ? 1 : -1, v & 4 ? 1 : -1);
      text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    const int faces[6][4] = {{2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}, {1, 3, 7, 5}, {0, 4, 6, 2}};
    const auto is_in = [](const std::vector<int>& list, int f) {
      return std::find(list.begin(), list.end(), f) != list.end();
    };
    for (int f = 0; f < 6; ++f) {
      if (is_in(cube.left_out, f)) continue;
      text += "f";
      for (int k = 0; k < 4; ++k)
        text += " " + std::to_string(before + 1 + faces[f][is_in(cube.turned, f) != cube.inwards ? 3 - k : k]);
      text += "\n";
    }
    before += 8;
  }
  return text;
}

Template fruit_of(const std::vector<std::string>& meshes, std::optional<bool> flip = {}) {
  Template fruit;
  fruit.name = "cubes";
  fruit.symmetry = NoSymmetry{};
  fruit.parts = {"skin", "flesh"};
  for (const std::string& obj : meshes) {
    MeshSketch mesh;
    mesh.name = "mesh" + std::to_string(fruit.meshes.size());
    mesh.file = std::make_shared<MeshFile>(MeshFile{"cubes.obj", MeshFormat::obj, obj});
    mesh.flip = flip;
    mesh.paint = MeshPaint{};
    mesh.paint->front.hidden = true;
    mesh.paint->front.color.along = Ramp<Color>::constant(Color(0.5f));
    mesh.paint->back.color.along = Ramp<Color>::constant(Color(0.5f));
    fruit.meshes.push_back(mesh);
  }
  return fruit;
}

Bodies bodies_of(const std::vector<Cube>& cubes, std::optional<bool> flip = {}) {
  return find_bodies(sweep(fruit_of({obj_of(cubes)}, flip)));
}

std::string message_of(const Template& fruit) {
  try {
    sweep(fruit);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Orientation, AMeshInsideOutIsTurned) {
  const Bodies bodies = bodies_of({{.inwards = true}});
  ASSERT_EQ(bodies.bodies.size(), 1u);
  EXPECT_DOUBLE_EQ(bodies.bodies[0].volume, 8);
  EXPECT_TRUE(bodies.warnings.empty());
}

TEST(Orientation, FacesThatLookTheOtherWayTurnToTheRest) {
  for (const std::vector<int>& turned : {std::vector{0}, std::vector{1, 4}, std::vector{0, 1, 2, 3}}) {
    const Bodies bodies = bodies_of({{.turned = turned}});
    ASSERT_EQ(bodies.bodies.size(), 1u);
    EXPECT_TRUE(bodies.bodies[0].closed);
    EXPECT_DOUBLE_EQ(bodies.bodies[0].volume, 8);
  }
}

TEST(Orientation, ShellsWithinShellsAreHollowsAndThingsInTheseSolid) {
  // For all 8 combinations of orientations in the file.
  for (int way = 0; way < 8; ++way) {
    const Bodies bodies = bodies_of({{.half = 3, .inwards = (way & 1) != 0},
                                     {.half = 2, .inwards = (way & 2) != 0},
                                     {.half = 1, .inwards = (way & 4) != 0}});
    double volume = 0;
    for (const Bodies::Body& body : bodies.bodies) volume += body.volume;
    EXPECT_EQ(bodies.bodies.size(), 2u);
    EXPECT_NEAR(volume, 216 - 64 + 8, 1e-9);
  }
}

TEST(Orientation, AHollowMayBeAMeshOfItsOwn) {
  const Template fruit = fruit_of({obj_of({{.half = 2}}), obj_of({{.half = 1}})});
  const Bodies bodies = find_bodies(sweep(fruit));
  ASSERT_EQ(bodies.bodies.size(), 1u);
  EXPECT_NEAR(bodies.bodies[0].volume, 64 - 8, 1e-9);
}

TEST(Orientation, NeighboursThatTouchAreBothSolid) {
  // A block of voxels that face outwards or inwards; no voxel lies within another.
  for (const bool inwards : {false, true}) {
    std::vector<Cube> voxels;
    for (int v = 0; v < 27; ++v)
      voxels.push_back({.at = 2.0 * glm::dvec3(v % 3, v / 3 % 3, v / 9), .inwards = inwards});
    const Bodies bodies = bodies_of(voxels);
    double volume = 0;
    for (const Bodies::Body& body : bodies.bodies) volume += body.volume;
    EXPECT_NEAR(volume, 27 * 8, 1e-9);
  }
}

TEST(Orientation, WhatCrossesFacesAsItsFileSays) {
  const std::vector<Cube> crossing{{.half = 2}, {.half = 1, .at = {2, 0, 0}}};
  EXPECT_EQ(bodies_of(crossing).bodies.size(), 2u);
  std::vector<Cube> inwards = crossing;
  inwards[1].inwards = true;
  const std::string told = message_of(fruit_of({obj_of(inwards)}));
  EXPECT_THAT(told, HasSubstr("mesh \"mesh0\": which way its shell at"));
  EXPECT_THAT(told, HasSubstr("flip = true"));
  EXPECT_EQ(message_of(fruit_of({obj_of(inwards)}, false)), "no error");
}

TEST(Orientation, AnOpenShellThatLooksInwardsIsAQuestion) {
  EXPECT_EQ(message_of(fruit_of({obj_of({{.left_out = {0}}})})), "no error");
  EXPECT_THAT(message_of(fruit_of({obj_of({{.inwards = true, .left_out = {0}}})})), HasSubstr("seems to face inwards"));
  EXPECT_EQ(message_of(fruit_of({obj_of({{.inwards = true, .left_out = {0}}})}, true)), "no error");
}

TEST(Orientation, AKeyIsTakenAtItsWord) {
  const Bodies bodies = bodies_of({{}}, true);
  ASSERT_EQ(bodies.warnings.size(), 1u);
  EXPECT_THAT(bodies.warnings[0], HasSubstr("surface \"mesh0\": a cavity wall lies in no skin"));
}

TEST(Orientation, WhatMayNotTurnStays) {
  DiffusionSurfaces ball = shapes::hollow_ball(0.05, 0.03, 3);
  const std::vector<glm::uvec3> before = ball.triangle;
  EXPECT_EQ(oriented(ball, std::vector<std::uint8_t>(before.size(), 0)).surfaces.triangle, before);
  EXPECT_EQ(oriented(ball, std::vector<std::uint8_t>(before.size(), 1)).surfaces.triangle, before);
}

}  // namespace
}  // namespace pomona
