// Meshes that face inwards, or partly so, are turned outwards like a solid, or reported.
#include "generator/surface/orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/surface/bodies.h"
#include "generator/surface/file/obj_file.h"
#include "generator/surface/file/outer_skin.h"
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

/// How the cubes of a file come by their vertices.
enum class Vertices { of_each_cube, of_each_face, of_all };

/// Faces of cubes as triangles; with `other_diagonal` diagonals of every other cube lie the other way.
std::string voxels_obj(const std::vector<Cube>& cubes, Vertices vertices, bool other_diagonal = false) {
  std::vector<glm::dvec3> all;
  std::string text, faces;
  std::size_t cube_start = 0;
  for (std::size_t c = 0; c < cubes.size(); ++c) {
    cube_start = vertices == Vertices::of_all ? 0 : all.size();
    const int corners[6][4] = {{2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}, {1, 3, 7, 5}, {0, 4, 6, 2}};
    for (const auto& face : corners) {
      const std::size_t from = vertices == Vertices::of_each_face ? all.size() : cube_start;
      std::array<std::size_t, 4> v{};
      for (std::size_t k = 0; k < 4; ++k) {
        const int i = face[cubes[c].inwards ? 3 - k : k];
        const glm::dvec3 p = cubes[c].at + cubes[c].half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        const auto found = std::find(all.begin() + static_cast<std::ptrdiff_t>(from), all.end(), p);
        v[k] = static_cast<std::size_t>(found - all.begin()) + 1;
        if (found == all.end()) all.push_back(p);
      }
      if (other_diagonal && c % 2 == 1) std::rotate(v.begin(), v.begin() + 1, v.end());
      for (const std::array<std::size_t, 3>& t : {std::array{v[0], v[1], v[2]}, std::array{v[0], v[2], v[3]}})
        faces += "f " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    }
  }
  for (const glm::dvec3& p : all)
    text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  return text + faces;
}

/// Every cube is a closed body of its own, its own triangles face away from its middle, and a cut leaves closed pieces.
void expect_solids(const DiffusionSurfaces& surfaces, const std::vector<Cube>& cubes) {
  const Bodies bodies = find_bodies(surfaces);
  EXPECT_EQ(bodies.bodies.size(), cubes.size());
  double volume = 0;
  for (const Bodies::Body& body : bodies.bodies) {
    EXPECT_TRUE(body.closed);
    volume += body.volume;
  }
  EXPECT_NEAR(volume, 8.0 * static_cast<double>(cubes.size()), 1e-9);
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    std::array<glm::dvec3, 3> p{};
    for (int k = 0; k < 3; ++k) p[static_cast<std::size_t>(k)] = glm::dvec3(surfaces.position[surfaces.triangle[t][k]]);
    const bool is_front = surfaces.is_hidden(t, SideOf::front);
    const double out = glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[0] - cubes[t / 12].at);
    EXPECT_EQ(out > 0, is_front) << "triangle " << t;
  }
}

/// Sides of 2; those numbered in `inwards` face inwards.
std::vector<Cube> row_of_cubes(int count, int inwards) {
  std::vector<Cube> cubes;
  for (int c = 0; c < count; ++c) cubes.push_back({.at = {2.0 * c, 0, 0}, .inwards = (inwards >> c & 1) != 0});
  return cubes;
}

TEST(Orientation, SolidsThatShareFacesAreSolidWhicheverWayEachFaces) {
  for (const Vertices vertices : {Vertices::of_each_cube, Vertices::of_each_face, Vertices::of_all}) {
    for (int inwards = 0; inwards < 8; ++inwards) {
      SCOPED_TRACE(std::to_string(static_cast<int>(vertices)) + ", " + std::to_string(inwards));
      const std::vector<Cube> cubes = row_of_cubes(3, inwards);
      expect_solids(sweep(fruit_of({voxels_obj(cubes, vertices)})), cubes);
    }
  }
}

TEST(Orientation, ABlockOfVoxelsIsSolidWhicheverWayEachFaces) {
  for (const Vertices vertices : {Vertices::of_each_cube, Vertices::of_each_face}) {
    for (const int every : {2, 3, 5}) {
      std::vector<Cube> voxels;
      for (int v = 0; v < 27; ++v)
        voxels.push_back({.at = 2.0 * glm::dvec3(v % 3, v / 3 % 3, v / 9), .inwards = (v * v) % every == 1});
      SCOPED_TRACE(std::to_string(static_cast<int>(vertices)) + ", " + std::to_string(every));
      const Bodies bodies = find_bodies(sweep(fruit_of({voxels_obj(voxels, vertices)})));
      double volume = 0;
      for (const Bodies::Body& body : bodies.bodies) {
        EXPECT_TRUE(body.closed);
        volume += body.volume;
      }
      EXPECT_NEAR(volume, 27 * 8, 1e-9);
    }
  }
}

/// A cube of side 2 as six tetrahedra around its diagonal; those numbered in `inwards` face inwards.
std::string tetrahedra_obj(int inwards, bool share_vertices) {
  std::string text, faces;
  int before = 0;
  const auto add_corners = [&](const std::vector<int>& corners) {
    for (const int i : corners)
      text += "v " + std::to_string(i & 1 ? 1 : -1) + " " + std::to_string(i & 2 ? 1 : -1) + " " +
              std::to_string(i & 4 ? 1 : -1) + "\n";
  };
  if (share_vertices) add_corners({0, 1, 2, 3, 4, 5, 6, 7});
  const int ways[6][2] = {{1, 3}, {2, 6}, {4, 5}, {3, 2}, {6, 4}, {5, 1}};  // the corners between 0 and 7
  for (int k = 0; k < 6; ++k) {
    const std::vector<int> corner{0, ways[k][0], ways[k][1], 7};
    if (!share_vertices) add_corners(corner);
    const int sides[4][3] = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
    for (const auto& side : sides) {
      faces += "f";
      for (int i = 0; i < 3; ++i) {
        const auto v = static_cast<std::size_t>(side[(inwards >> k & 1) != 0 ? 2 - i : i]);
        faces += " " + std::to_string(share_vertices ? corner[v] + 1 : before + static_cast<int>(v) + 1);
      }
      faces += "\n";
    }
    before += 4;
  }
  return text + faces;
}

TEST(Orientation, TetrahedraFillTheirBlockWhicheverWayEachFaces) {
  for (const bool share_vertices : {false, true}) {
    for (int inwards = 0; inwards < 64; ++inwards) {
      SCOPED_TRACE(std::to_string(inwards) + (share_vertices ? ", shared vertices" : ""));
      const Bodies bodies = find_bodies(sweep(fruit_of({tetrahedra_obj(inwards, share_vertices)})));
      double volume = 0;
      for (const Bodies::Body& body : bodies.bodies) {
        EXPECT_TRUE(body.closed);
        volume += body.volume;
      }
      EXPECT_NEAR(volume, 8, 1e-9);
    }
  }
}

/// Two wedges that share an edge, and cross behind it: one is not the other's hollow.
TEST(Orientation, WhatSharesAnEdgeAndCrossesIsUnited) {
  const auto wedge = [](double from_x, double from_y, double to_x, double to_y) {
    std::string text;
    const double corner[3][2] = {{0, 0}, {from_x, from_y}, {to_x, to_y}};
    for (const int z : {0, 1})
      for (const auto& c : corner)
        text += "v " + std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(z) + "\n";
    return text;
  };
  const std::string both = wedge(2, 0, 0, 2) + wedge(2, 2, -2, 2);
  std::string faces;
  for (const int first : {1, 7}) {
    for (const auto& f : {std::array{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}) {
      faces += "f";
      for (const int v : f)
        if (v >= 0) faces += " " + std::to_string(first + v);
      faces += "\n";
    }
  }
  const DiffusionSurfaces surfaces = sweep(fruit_of({both + faces}));
  for (const Bodies::Body& body : find_bodies(surfaces).bodies) EXPECT_GT(body.volume, 0);
  double volume = 0;
  for (const Bodies::Body& body : find_bodies(surfaces).bodies) volume += body.volume;
  EXPECT_NEAR(volume, 2 + 4, 1e-6) << "one 2, the other 4; a cut unites them";
}

TEST(Orientation, SharedFacesMayBeTriangulatedInTwoWays) {
  for (const Vertices vertices : {Vertices::of_each_cube, Vertices::of_each_face}) {
    for (int inwards = 0; inwards < 4; ++inwards) {
      const std::vector<Cube> cubes = row_of_cubes(2, inwards);
      expect_solids(sweep(fruit_of({voxels_obj(cubes, vertices, true)})), cubes);
    }
  }
}

TEST(Orientation, SolidsThatShareFacesMayBeMeshesOfTheirOwn) {
  for (int inwards = 0; inwards < 4; ++inwards) {
    const std::vector<Cube> cubes = row_of_cubes(2, inwards);
    expect_solids(sweep(fruit_of({voxels_obj({cubes[0]}, Vertices::of_each_face),
                                  voxels_obj({cubes[1]}, Vertices::of_each_face)})),
                  cubes);
  }
}

TEST(Orientation, AMeshWithoutAWordOnItsSidesMayHoldSolidsThatShareFaces) {
  for (const Vertices vertices : {Vertices::of_each_cube, Vertices::of_each_face, Vertices::of_all}) {
    for (int inwards = 0; inwards < 8; ++inwards) {
      SCOPED_TRACE(std::to_string(static_cast<int>(vertices)) + ", " + std::to_string(inwards));
      const std::vector<Cube> cubes = row_of_cubes(3, inwards);
      const PlainMesh mesh = parse_obj(voxels_obj(cubes, vertices), "voxels.obj", "");
      DiffusionSurfaces plain;
      plain.surface_names = {"voxels"};
      plain.part_names = {"flesh"};
      for (const glm::dvec3& p : mesh.position) plain.position.emplace_back(p);
      plain.front_color.assign(plain.position.size(), Color(0.5f));
      plain.back_color = plain.front_color;
      plain.blur.assign(plain.position.size(), 0);
      plain.front_hidden.assign(plain.position.size(), 0);
      plain.back_hidden = plain.front_hidden;
      plain.triangle = mesh.triangle;
      plain.surface.assign(plain.triangle.size(), 0);
      plain.front_part = plain.back_part = plain.surface;
      expect_solids(with_outer_skin(plain), cubes);
    }
  }
}

TEST(Orientation, WhatFillsAHollowWhollyIsCountedOnce) {
  for (int way = 0; way < 8; ++way) {
    SCOPED_TRACE(way);
    const Bodies bodies = bodies_of({{.half = 2, .inwards = (way & 1) != 0},
                                     {.half = 1, .inwards = (way & 2) != 0},
                                     {.half = 1, .inwards = (way & 4) != 0}});
    double volume = 0;
    for (const Bodies::Body& body : bodies.bodies) volume += body.volume;
    EXPECT_NEAR(volume, 64, 1e-9);
  }
}

TEST(Orientation, AShellThatIsThereTwiceCountsOnce) {
  for (int way = 0; way < 8; ++way) {
    SCOPED_TRACE(way);
    const Cube a{.inwards = (way & 1) != 0}, b{.inwards = (way & 2) != 0}, c{.inwards = (way & 4) != 0};
    EXPECT_EQ(bodies_of({a, b, c}).bodies.size(), 1u);
    const Bodies in_two_meshes = find_bodies(sweep(fruit_of({obj_of({a}), obj_of({b})})));
    ASSERT_EQ(in_two_meshes.bodies.size(), 1u);
    EXPECT_DOUBLE_EQ(in_two_meshes.bodies[0].volume, 8);
    EXPECT_TRUE(in_two_meshes.warnings.empty());
  }
  // With a hollow, and beside another of its size.
  const Bodies hollow = bodies_of({{.half = 2}, {.half = 1}, {.half = 2}, {.half = 2, .at = {9, 0, 0}}});
  double volume = 0;
  for (const Bodies::Body& body : hollow.bodies) volume += body.volume;
  EXPECT_NEAR(volume, 64 - 8 + 64, 1e-9);
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
