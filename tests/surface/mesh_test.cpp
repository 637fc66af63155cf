// Meshes from modelling tools: every format gives the same surfaces, and hostile files give a clear error.
#include "generator/surface/sweep/mesh_surfaces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/surface/bodies.h"
#include "generator/surface/file/glb_file.h"
#include "generator/surface/file/obj_file.h"
#include "generator/surface/file/plain_mesh_file.h"
#include "generator/surface/file/surface_file.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/read/read_template.h"
#include "tests/base/temporary_folder.h"
#include "tests/shapes/shapes.h"
#include "tests/surface/mesh_files.h"

namespace pomona {
namespace {

using namespace mesh_files;
using ::testing::HasSubstr;

MeshSketch sketch_of(MeshFormat format, const std::string& bytes, const std::string& object = {}) {
  MeshSketch mesh;
  mesh.name = "cube";
  mesh.file = std::make_shared<MeshFile>(MeshFile{"cube.mesh", format, bytes});
  mesh.object = object;
  MeshPaint paint;
  paint.front.hidden = true;
  paint.front.color.along = {{{0.0, Color(0.0f)}, {1.0, Color(1.0f)}}};
  paint.back.part = 1;
  paint.back.color.along = Ramp<Color>::constant(Color(0.25f));
  mesh.paint = paint;
  return mesh;
}

Template fruit_of(const std::vector<MeshSketch>& meshes) {
  Template fruit;
  fruit.name = "cube";
  fruit.symmetry = NoSymmetry{};
  fruit.parts = {"skin", "flesh"};
  fruit.meshes = meshes;
  return fruit;
}

std::string message_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return to_string(error.diagnostics().front());
  }
  return "no error";
}

// ---- Doors ----

TEST(Mesh, ObjAndGlbGiveTheSameClosedSkin) {
  for (const MeshSketch& mesh : {sketch_of(MeshFormat::obj, cube_obj()), sketch_of(MeshFormat::glb, cube_glb())}) {
    const DiffusionSurfaces cube = sweep(fruit_of({mesh}));
    EXPECT_EQ(cube.triangle_count(), 12u);
    EXPECT_DOUBLE_EQ(shapes::signed_volume(cube), 8.0);
    EXPECT_EQ(cube.surface_names, std::vector<std::string>{"cube"});
    EXPECT_EQ(cube.part_names, (std::vector<std::string>{"skin", "flesh"}));
    EXPECT_TRUE(find_bodies(cube).warnings.empty());
    EXPECT_TRUE(cube.is_hidden(0, SideOf::front));
    EXPECT_FALSE(cube.is_hidden(0, SideOf::back));
  }
}

TEST(Mesh, RampsRunWithHeightOrWithDistance) {
  MeshSketch mesh = sketch_of(MeshFormat::obj, cube_obj());
  const DiffusionSurfaces by_height = sweep(fruit_of({mesh}));
  for (std::size_t v = 0; v < by_height.vertex_count(); ++v) {
    EXPECT_EQ(by_height.front_color[v].r, by_height.position[v].y > 0 ? 1.0f : 0.0f);
    EXPECT_EQ(by_height.back_color[v], Color(0.25f));
  }
  mesh.paint->ramps_from = glm::dvec3(1, 1, 1);
  const DiffusionSurfaces by_distance = sweep(fruit_of({mesh}));
  for (std::size_t v = 0; v < by_distance.vertex_count(); ++v) {
    const double share = glm::distance(glm::dvec3(by_distance.position[v]), glm::dvec3(1)) / std::sqrt(12.0);
    EXPECT_NEAR(by_distance.front_color[v].r, share, 1e-6);
  }
}

TEST(Mesh, LiesWhereTheTemplatePutsIt) {
  MeshSketch mesh = sketch_of(MeshFormat::obj, cube_obj(), "lid");
  mesh.unit = 1e-3;
  mesh.z_up = true;
  mesh.at = {0, 0.5, 0};
  const DiffusionSurfaces lid = sweep(fruit_of({mesh}));
  ASSERT_EQ(lid.triangle_count(), 2u);
  EXPECT_EQ(lid.vertex_count(), 4u);
  for (const glm::vec3& p : lid.position) {
    EXPECT_FLOAT_EQ(p.z, -0.001f);  // the file's Y axis points to the back
    EXPECT_NEAR(std::fabs(p.y - 0.5f), 0.001f, 1e-7f);
  }
  mesh.flip = true;
  const DiffusionSurfaces turned = sweep(fruit_of({mesh}));
  EXPECT_EQ(turned.triangle[0], glm::uvec3(lid.triangle[0].x, lid.triangle[0].z, lid.triangle[0].y));
}

TEST(Mesh, ObjectsAreFoundByAnyOfTheirNames) {
  EXPECT_EQ(parse_obj(cube_obj(), "x", "box").triangle.size(), 10u);
  EXPECT_EQ(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\ng a b\nf 1 2 3\n", "x", "a b").triangle.size(), 1u);
  EXPECT_EQ(parse_glb(cube_glb(), "x", "lid").triangle.size(), 2u);
  EXPECT_EQ(parse_glb(cube_glb(), "x", "box_data").triangle.size(), 10u);
}

TEST(Mesh, GlbFollowsTransformsAndTurnsMirroredMeshesOutside) {
  const PlainMesh moved = parse_glb(cube_glb(), "x", "");
  EXPECT_EQ(std::min_element(moved.position.begin(), moved.position.end(),
                             [](const auto& a, const auto& b) { return a.y < b.y; })
                ->y,
            0.0);
  const PlainMesh mirrored = parse_glb(cube_glb({"\"translation\":[0,1,0]", "\"scale\":[-1,2,1]"}), "x", "");
  double volume = 0;
  for (const glm::uvec3& t : mirrored.triangle) {
    volume += glm::dot(mirrored.position[t.x], glm::cross(mirrored.position[t.y], mirrored.position[t.z])) / 6;
  }
  EXPECT_DOUBLE_EQ(volume, 16.0);
}

TEST(Mesh, TakesTheFilesOwnColors) {
  MeshSketch mesh = sketch_of(MeshFormat::glb, cube_glb());
  mesh.paint->front_color_from_file = true;
  const DiffusionSurfaces cube = sweep(fruit_of({mesh}));
  for (const Color& color : cube.front_color) EXPECT_EQ(color, Color(1.0f, 0.0f, 0.2f));
  for (const Color& color : cube.back_color) EXPECT_EQ(color, Color(0.25f));

  const PlainMesh painted = parse_obj("v 0 0 0 1 0 0.5\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n", "x", "");
  ASSERT_EQ(painted.color.size(), 3u);
  EXPECT_FLOAT_EQ(painted.color[0].r, 1.0f);
  EXPECT_FLOAT_EQ(painted.color[0].b, static_cast<float>(linear_from_srgb(0.5)));
  EXPECT_TRUE(parse_obj("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n", "x", "").color.empty());

  mesh = sketch_of(MeshFormat::obj, cube_obj());
  mesh.paint->back_color_from_file = true;
  EXPECT_THAT(message_of([&] { sweep(fruit_of({mesh})); }), HasSubstr("mesh \"cube\": the file has no colours"));
}

// ---- Surface files ----

TEST(Mesh, SurfaceFileSaysAllItself) {
  shapes::Paint paint;
  paint.back_part = "gel";
  const DiffusionSurfaces ball = joined(shapes::hollow_ball(0.05, 0.03, 4), shapes::sphere(0.02, 3, paint));
  MeshSketch mesh = sketch_of(MeshFormat::ply, write_surfaces(ball));
  mesh.paint.reset();
  Template fruit = fruit_of({mesh});
  fruit.parts = ball.part_names;
  const DiffusionSurfaces grown = sweep(fruit);
  EXPECT_TRUE(write_surfaces(grown) == write_surfaces(ball));

  std::reverse(fruit.parts.begin(), fruit.parts.end());
  const DiffusionSurfaces renumbered = sweep(fruit);
  for (std::size_t i = 0; i < ball.triangle_count(); ++i) {
    EXPECT_EQ(renumbered.part_names[static_cast<std::size_t>(renumbered.back_part[i])],
              ball.part_names[static_cast<std::size_t>(ball.back_part[i])]);
  }
  fruit.parts = {"nothing"};
  EXPECT_THAT(message_of([&] { sweep(fruit); }), HasSubstr("is not one of the template's parts"));
}

TEST(Mesh, SurfacesOfAFileMayBePickedAndPaintedOver) {
  const DiffusionSurfaces ball = joined(shapes::sphere(0.05, 4), shapes::sphere(0.02, 3));
  DiffusionSurfaces named = ball;
  named.surface_names = {"skin", "stone"};
  MeshSketch mesh = sketch_of(MeshFormat::ply, write_surfaces(named), "stone");
  const DiffusionSurfaces stone = sweep(fruit_of({mesh}));
  EXPECT_EQ(stone.triangle_count(), static_cast<std::size_t>(std::count(ball.surface.begin(), ball.surface.end(), 1)));
  EXPECT_EQ(stone.back_color[0], Color(0.25f));
  mesh.object = "kernel";
  EXPECT_THAT(message_of([&] { sweep(fruit_of({mesh})); }), HasSubstr("it has: skin, stone"));
}

// ---- The kidney ----

const std::filesystem::path templates = std::filesystem::path(POMONA_SOURCE_DIR) / "templates";

TEST(Kidney, IsOneClosedBodyAsFineAsThePapers) {
  const Template fruit = read_template(templates / "kidney.toml");
  EXPECT_TRUE(std::holds_alternative<NoSymmetry>(fruit.symmetry));
  const DiffusionSurfaces kidney = sweep(fruit);
  EXPECT_GE(kidney.triangle_count(), 5694u);  // the paper's Table 1
  EXPECT_EQ(kidney.part_names, fruit.parts);
  const Bodies bodies = find_bodies(kidney);
  EXPECT_TRUE(bodies.warnings.empty());
  const glm::dvec3 size = bounds_of(kidney).size();
  EXPECT_NEAR(size.y, 0.11, 0.003);
  EXPECT_NEAR(size.z, 0.032, 0.003);
}

TEST(Kidney, TemplateAndFileAreTheSame) {
  const DiffusionSurfaces grown = sweep(read_template(templates / "kidney.toml"));
  EXPECT_TRUE(write_surfaces(grown) == write_surfaces(read_surfaces(templates / "kidney.ply")));
}

/// The number of triangles that face air, or of those of one surface.
DiffusionSurfaces chosen(const DiffusionSurfaces& all, const std::string& surface) {
  DiffusionSurfaces result = all;
  result.triangle.clear();
  for (std::size_t i = 0; i < all.triangle_count(); ++i) {
    const bool is_named = all.surface_names[static_cast<std::size_t>(all.surface[i])] == surface;
    if (surface.empty() ? all.is_boundary(i) : is_named) result.triangle.push_back(all.triangle[i]);
  }
  return result;
}

TEST(Kidney, ComesThroughEveryDoorAlike) {
  const DiffusionSurfaces kidney = read_surfaces(templates / "kidney.ply");
  const DiffusionSurfaces boundary = chosen(kidney, ""), pyramids = chosen(kidney, "pyramids");
  const auto painted = [](MeshSketch skin, MeshSketch inside) {
    inside.paint->front.hidden = false;
    inside.paint->front.part = 1;
    inside.paint->ramps_from = glm::dvec3(0.01, 0.055, 0);
    return write_surfaces(sweep(fruit_of({std::move(skin), std::move(inside)})));
  };
  const std::string by_obj = painted(sketch_of(MeshFormat::obj, obj_of(boundary, "skin"), "skin"),
                                     sketch_of(MeshFormat::obj, obj_of(pyramids, "pyramids"), "pyramids"));
  const std::string by_glb = painted(sketch_of(MeshFormat::glb, glb_of(boundary, "skin"), "skin"),
                                     sketch_of(MeshFormat::glb, glb_of(pyramids, "pyramids"), "pyramids"));
  EXPECT_TRUE(by_obj == by_glb);
  EXPECT_TRUE(find_bodies(parse_surfaces(by_obj, "kidney")).warnings.empty());

  MeshSketch by_ply = sketch_of(MeshFormat::ply, write_surfaces(kidney), "pyramids");
  const std::string by_three = painted(sketch_of(MeshFormat::obj, obj_of(boundary, "skin")), std::move(by_ply));
  EXPECT_TRUE(by_obj == by_three);
}

// ---- Mistakes ----

TEST(Mesh, ObjFacesOfTwoCornersAreLeftOutAndTold) {
  const PlainMesh mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n", "x.obj", {});
  EXPECT_EQ(mesh.triangle.size(), 1u);
  EXPECT_THAT(mesh.notes, testing::ElementsAre("a face of less than three corners is left out"));
}

TEST(Mesh, ObjMistakesHaveLineAndColumn) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", "holds no faces"},
      {three, "holds no faces"},
      {"v 0 0\n", "x.obj:1:6: error: a vertex needs three numbers"},
      {"v 0 0 nan\n", "x.obj:1:7: error: this number is not finite"},
      {"v 0 0 1e999\n", "x.obj:1:7: error: this is not a number"},
      {"v 0 0 1e30\n", "x.obj:1:7: error: this number is too large"},
      {"v 0 0 0x1\n", "x.obj:1:7: error: this is not a number"},
      {three + "f 1 2\n", "holds no faces"},
      {three + "f 1 2 4\n", "x.obj:4:7: error: there is no such vertex"},
      {three + "f 1 2 -4\n", "there is no such vertex"},
      {three + "f 0 1 2\n", "x.obj:4:3: error: there is no such vertex"},
      {three + "f 1 2 99999999999999999999\n", "not the number of a vertex"},
      {three + "f 1 2 3x\n", "not the number of a vertex"},
      {std::string("\0\0\0\0", 4), "begins with a keyword"},
  };
  for (const auto& [text, message] : mistakes) {
    EXPECT_THAT(message_of([&, &text = text] { parse_obj(text, "x.obj", ""); }), HasSubstr(message)) << text;
  }
  EXPECT_THAT(message_of([] { parse_obj(cube_obj(), "x.obj", "bottom"); }), HasSubstr("it has: lid, box"));
}

TEST(Mesh, AFileOfAnotherKindIsRefusedAsAWhole) {
  try {
    read_plain_mesh("bowl.stl");
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    const SourcePlace& place = error.diagnostics().front().place;
    EXPECT_EQ(place.file, "bowl.stl");
    EXPECT_EQ(place.line, 0);
    EXPECT_EQ(place.column, 0);
    EXPECT_THAT(error.what(), testing::StartsWith("bowl.stl: error: is no mesh that can be read"));
  }
}

TEST(Mesh, GlbMistakesNameTheMesh) {
  std::string nan = cube_bin();
  nan.replace(0, 4, std::string("\0\0\xc0\x7f", 4));
  std::string far_index = cube_bin();
  far_index[128] = 8;
  const std::string good = cube_glb();
  std::string version = good;
  version[4] = 1;
  const std::string nested = std::string(20000, '[') + std::string(20000, ']');
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", "no binary glTF"},
      {"{}", "no binary glTF"},
      {good.substr(0, 40), "length is not the one"},
      {version, "only version 2"},
      {glb(cube_json(), nan), "primitive 0, vertex 0: error: its position is not finite"},
      {glb(cube_json(), far_index), "triangle 0: error: there is no such vertex"},
      {cube_glb({"\"asset\":{", "\"asset\":{\"extras\":" + nested + ","}), "nested more than 64 deep"},
      {cube_glb({"\"count\":8", "\"count\":9000000000000000000"}), "must be a whole number"},
      {cube_glb({"\"count\":8", "\"count\":9"}), "longer than its bytes"},
      {cube_glb({"\"byteOffset\":96,\"byteLength\":32", "\"byteOffset\":190,\"byteLength\":32"}), "ends early"},
      {cube_glb({"\"mesh\":1", "\"mesh\":7"}), "no such mesh"},
      {cube_glb({"\"children\":[1,2]", "\"children\":[0]"}), "within itself"},
      {cube_glb({"\"children\":[1,2]", "\"children\":[9]"}), "no such node"},
      {cube_glb({"\"children\":[1,2]", "\"children\":[]"}), "holds no triangles"},
      {cube_glb({"\"indices\":2", "\"indices\":2,\"mode\":1"}), "points or lines"},
      {cube_glb({"\"POSITION\":0,", ""}), "has no positions"},
      {cube_glb({"5126", "5123"}), "positions must be three floats"},
      {cube_glb({"\"indices\":2", "\"indices\":0"}), "whole numbers"},
      {cube_glb({"\"buffers\":[{\"byteLength\":200}]", "\"buffers\":[{\"byteLength\":200,\"uri\":\"/etc/passwd\"}]"}),
       "error"},
      {glb("{\"asset\":", {}), "no glTF that can be read"},
  };
  for (const auto& [bytes, message] : mistakes) {
    EXPECT_THAT(message_of([&, &bytes = bytes] { parse_glb(bytes, "x.glb", ""); }), HasSubstr(message));
  }
  EXPECT_THAT(message_of([] { parse_glb(cube_glb(), "x.glb", "handle"); }), HasSubstr("it has: lid, box"));
}

/// Random bytes are damaged: the result is an error or a mesh, never a crash.
TEST(Mesh, SpoiltFilesAreReadOrRefused) {
  const RandomStream random(VariantKey{1, 0}, "spoilt meshes");
  std::uint64_t draw = 0;
  for (const std::string& good : {cube_obj(), cube_glb()}) {
    for (int round = 0; round < 3000; ++round) {
      std::string spoilt = good;
      for (int k = 0; k < 1 + round % 4; ++k) {
        const auto at = static_cast<std::size_t>(random.uniform(draw++) * static_cast<double>(spoilt.size()));
        spoilt[at] = static_cast<char>(random.uniform(draw++) * 256 - 128);
      }
      try {
        const PlainMesh mesh = good[0] == 'g' ? parse_glb(spoilt, "x", "") : parse_obj(spoilt, "x", "");
        for (const glm::uvec3& t : mesh.triangle) {
          EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.position.size());
        }
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::bad_data);
      }
    }
    for (std::size_t size = 0; size < good.size(); size += 7) {
      try {
        const std::string cut = good.substr(0, size);
        good[0] == 'g' ? parse_glb(cut, "x", "") : parse_obj(cut, "x", "");
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::bad_data);
      }
    }
  }
}

/// A template beside the kidney's that differs in its [[mesh]].
std::string template_with(const std::string& mesh, const std::string& kind = "none") {
  return "format = 1\nname = \"x\"\nparts = [\"a\", \"b\"]\n[symmetry]\nkind = \"" + kind + "\"\n" + mesh;
}

TEST(MeshInTemplate, MayBePaintedAndPlaced) {
  const Template fruit = parse_template(
      template_with("[[mesh]]\nname = \"m\"\nfile = \"kidney.ply\"\nobject = \"pyramids\"\nunit = \"1cm\"\nup = \"z\"\n"
                    "flip = true\nat = [\"1mm\", \"2mm\", \"3mm\"]\nramps_from = [\"10mm\", \"0mm\", \"0mm\"]\n"
                    "blur = \"1mm\"\nfront = { part = \"a\" }\nback = { part = \"b\", color = \"#ffffff\" }\n"),
      (templates / "x.toml").string());
  ASSERT_EQ(fruit.meshes.size(), 1u);
  const MeshSketch& mesh = fruit.meshes[0];
  EXPECT_EQ(mesh.object, "pyramids");
  EXPECT_EQ(mesh.unit, 0.01);
  EXPECT_TRUE(mesh.z_up && mesh.flip);
  EXPECT_EQ(mesh.at, glm::dvec3(0.001, 0.002, 0.003));
  ASSERT_TRUE(mesh.paint.has_value());
  EXPECT_TRUE(mesh.paint->front_color_from_file);
  EXPECT_FALSE(mesh.paint->back_color_from_file);
  EXPECT_EQ(mesh.paint->back.part, 1);
  EXPECT_GT(sweep(fruit).triangle_count(), 1000u);
}

TEST(MeshInTemplate, MistakesAreToldAtTheirPlace) {
  const std::string head = "[[mesh]]\nname = \"m\"\n";
  const std::string sides = "front = { part = \"a\" }\nback = { part = \"b\" }\n";
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", "1:1: error: the file lacks"},
      {head, "6:1: error: mesh \"m\": lacks \"file\""},
      {head + "file = \"none.ply\"\n", "8:8: error: mesh \"m\": file cannot be read"},
      {head + "file = \"../README.ply\"\n", "8:8: error: mesh \"m\": file leads out of the template's folder"},
      {head + "file = \"/etc/passwd.ply\"\n", "leads out of the template's folder"},
      {head + "file = \"kidney.toml\"\n", "8:8: error: mesh \"m\": file is no mesh that can be read"},
      {head + "file = \"kidney.ply\"\n" + "front = { part = \"a\" }\n", "mesh \"m\": lacks \"back\""},
      {head + "file = \"kidney.ply\"\nunit = \"2000m\"\n", "9:8: error: mesh \"m\": unit is 2000m"},
      {head + "file = \"kidney.ply\"\nup = \"x\"\n", "mesh \"m\": up \"x\" is not known"},
      {head + "file = \"kidney.ply\"\nat = [\"1mm\"]\n", "mesh \"m\": at must be three lengths"},
      {head + "file = \"kidney.ply\"\nfile_name = \"y\"\n", "unknown key \"file_name\""},
      {head + "file = \"kidney.ply\"\n" + sides + head + "file = \"kidney.ply\"\n", "\"m\" is there already"},
  };
  for (const auto& [text, message] : mistakes) {
    EXPECT_THAT(message_of([&, &text = text] { parse_template(template_with(text), (templates / "x.toml").string()); }),
                HasSubstr(message));
  }
}

TEST(MeshInTemplate, AFileIsReadOnceHoweverManyShowIt) {
  const TemporaryFolder folder;
  for (const char* name : {"a.obj", "b.obj"}) std::ofstream(folder / name) << cube_obj();
  std::string meshes;
  for (const char* file : {"a", "b", "a"})
    meshes += "[[mesh]]\nname = \"m" + std::to_string(meshes.size()) + "\"\nfile = \"" + file + ".obj\"\n" +
              "front = { part = \"a\" }\nback = { part = \"b\" }\n";
  const Template fruit = parse_template(template_with(meshes), folder / "x.toml");
  ASSERT_EQ(fruit.meshes.size(), 3u);
  EXPECT_EQ(fruit.meshes[0].file, fruit.meshes[2].file);
  EXPECT_NE(fruit.meshes[0].file, fruit.meshes[1].file);
  EXPECT_EQ(std::filesystem::path(fruit.meshes[1].file->path).filename(), "b.obj");
}

TEST(MeshInTemplate, WhatIsWrongInALineOfItsFileIsToldThere) {
  const TemporaryFolder folder;
  const std::string mesh =
      "[[mesh]]\nname = \"m\"\nfile = \"x.obj\"\nfront = { part = \"a\" }\nback = { part = \"b\" }\n";
  std::ofstream(folder / "x.toml") << template_with(mesh);
  const auto told = [&](const std::string& obj) {
    std::ofstream(folder / "x.obj") << obj;
    return message_of([&] { sweep(read_template(folder / "x.toml")); });
  };
  EXPECT_THAT(told("v 0 0\n"), HasSubstr("x.obj:1:6: error: a vertex needs three numbers"));
  EXPECT_THAT(told("v 0 0 0\nv 0 0\n"), HasSubstr("x.obj:2:6: error: a vertex needs three numbers"));
  EXPECT_THAT(told("v 0 0 0\n"), HasSubstr("x.obj:1:1: error: holds no faces"));
}

/// Each mesh is allowed, but all together would fill the memory.
TEST(Mesh, AllOfATemplateHaveALimitTogether) {
  const Template fruit = fruit_of({sketch_of(MeshFormat::obj, cube_obj())});
  EXPECT_NO_THROW(check_meshes_together(fruit, fruit.meshes[0], max_mesh_triangles));
  EXPECT_THAT(message_of([&] { check_meshes_together(fruit, fruit.meshes[0], max_mesh_triangles + 1); }),
              HasSubstr("mesh \"cube\": with it the meshes have more than 2 000 000 triangles together"));
}

TEST(Mesh, WrongUnitsAreFound) {
  MeshSketch mesh = sketch_of(MeshFormat::obj, cube_obj());
  mesh.unit = 1000;
  EXPECT_THAT(message_of([&] { sweep(fruit_of({mesh})); }), HasSubstr("larger than 100 m"));
  mesh.unit = 1e-7;
  EXPECT_THAT(message_of([&] { sweep(fruit_of({mesh})); }), HasSubstr("it has no size"));
}

}  // namespace
}  // namespace pomona
