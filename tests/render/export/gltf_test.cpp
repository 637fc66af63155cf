#include "render/export/gltf/write_glb.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <map>
#include <set>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "render/export/look_palette.h"
#include "render/export/output.h"
#include "render/export/pbr_material.h"
#include "render/style/style_file.h"
#include "render/texture/texture_pages.h"
#include "tests/base/temporary_folder.h"
#include "tests/render/export/named_solids.h"
#include "tests/render/export/read_glb.h"

namespace pomona {
namespace {

using testing::ElementsAre;
using Json = nlohmann::json;

TEST(Gltf, ReadsBackAsItWas) {
  const Scene scene = named::mixed();
  const named::Glb glb = named::read_glb(write_glb(scene, {.provenance = "pomona cut tomato"}));
  ASSERT_EQ(glb.meshes.size(), 3u) << "the empty solid is no mesh";
  EXPECT_EQ(glb.provenance, "pomona cut tomato");
  EXPECT_DOUBLE_EQ(glb.vertical_field, scene.view.vertical_field);

  // Compare every corner of every triangle: welding may renumber vertices but not change them.
  const Solid& box = scene.solids[0];
  const named::GlbMesh& mesh = glb.meshes[0];
  EXPECT_EQ(mesh.name, "box");
  EXPECT_THAT(mesh.part_names, ElementsAre("skin", "flesh"));
  EXPECT_DOUBLE_EQ(mesh.volume, box.volume);
  ASSERT_EQ(mesh.triangle.size(), box.mesh.triangle.size());
  for (std::size_t t = 0; t < box.mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t ours = box.mesh.triangle[t][k], theirs = mesh.triangle[t][k];
      EXPECT_EQ(mesh.position[theirs], box.mesh.position[ours]);
      EXPECT_EQ(mesh.normal[theirs], box.mesh.normal[ours]);
      EXPECT_EQ(mesh.part[theirs], box.mesh.part[ours]);
      EXPECT_LT(glm::length(mesh.color[theirs] - box.mesh.color[ours]), 2e-5f);
    }
  }
}

TEST(Gltf, SharesAMeshBetweenInstancesAndKeepsTheirPoses) {
  const Scene scene = named::mixed();
  const named::Glb glb = named::read_glb(write_glb(scene));
  ASSERT_EQ(glb.nodes.size(), 5u) << "box twice, leaf, see-through ball, camera";
  EXPECT_EQ(glb.nodes[0].mesh, glb.nodes[1].mesh);
  EXPECT_EQ(glb.nodes[1].name, "box there");
  const glm::dvec3 corner(0.05, 0.03, 0.02);
  const Pose& pose = scene.instances[1].pose;
  const glm::dvec3 expected = pose.rotation * corner + pose.translation;
  EXPECT_LT(glm::length(glm::dvec3(glb.nodes[1].matrix * glm::dvec4(corner, 1)) - expected), 1e-12);
}

TEST(Gltf, LevelsAreNodesOutsideTheSceneInTheirInstancesPlaces) {
  // Two levels of the box, none of the leaf, one of the transparent ball.
  const Scene scene = named::mixed();
  std::vector<std::vector<Solid>> levels(scene.solids.size());
  levels[0] = {scene.solids[0], scene.solids[0]};
  levels[0][1].mesh.triangle.resize(4);
  levels.back() = {scene.solids.back()};
  const named::Glb glb = named::read_glb(write_glb(scene, {}, levels));
  EXPECT_THAT(glb.extensions_used, testing::Contains("MSFT_lod"));
  EXPECT_THAT(glb.extensions_required, testing::IsEmpty()) << "who does not know levels shows the solids";

  std::size_t shown = 0;
  for (const named::GlbNode& node : glb.nodes) {
    if (!node.is_in_scene) continue;
    ++shown;
    for (std::size_t k = 0; k < node.levels.size(); ++k) {
      const named::GlbNode& level = glb.nodes.at(node.levels[k]);
      EXPECT_EQ(level.name, node.name + "_LOD" + std::to_string(k + 1));
      EXPECT_EQ(level.matrix, node.matrix);
      EXPECT_FALSE(level.is_in_scene);
      EXPECT_NE(level.mesh, node.mesh);
    }
    EXPECT_EQ(node.screen_coverage.size(), node.levels.empty() ? 0 : node.levels.size() + 1);
  }
  EXPECT_EQ(shown, 5u);
  EXPECT_THAT(glb.nodes[2].levels, ElementsAre(0, 1)) << "the box";
  EXPECT_THAT(glb.nodes[2].screen_coverage, ElementsAre(0.1, 0.05, 0.0));
  EXPECT_EQ(glb.meshes[glb.nodes[1].mesh].triangle.size(), 4u);
  EXPECT_EQ(glb.nodes[3].mesh, glb.nodes[0].mesh) << "the second box shares the meshes of levels, too";
}

TEST(Gltf, LooksWhereTheSceneLooks) {
  const Scene scene = named::axes_of_balls();
  const named::GlbNode camera = named::read_glb(write_glb(scene)).nodes.back();
  ASSERT_EQ(camera.camera, 0);
  // The target lies straight ahead (-Z of the camera), and +Y points up in the picture.
  const glm::dmat4 to_camera = glm::inverse(camera.matrix);
  const glm::dvec3 target(to_camera * glm::dvec4(scene.view.target, 1));
  EXPECT_NEAR(target.x, 0, 1e-12);
  EXPECT_NEAR(target.y, 0, 1e-12);
  EXPECT_LT(target.z, -0.1);
  EXPECT_GT((to_camera * glm::dvec4(0, 1, 0, 0)).y, 0.5);
}

TEST(Gltf, OpenMeshesShowBothSidesAndSeeThroughOnesBlend) {
  const named::Glb glb = named::read_glb(write_glb(named::mixed()));
  EXPECT_FALSE(glb.meshes[0].double_sided);
  EXPECT_TRUE(glb.meshes[1].double_sided);
  EXPECT_FALSE(glb.meshes[2].double_sided) << "its far side has triangles of its own";
  EXPECT_DOUBLE_EQ(glb.meshes[2].alpha, 0.25);
}

TEST(Gltf, IndicesAreAsNarrowAsTheyCanBe) {
  Scene scene;
  scene.solids = {named::ball("small", 0.1f, 4, Color(0.5f)), named::ball("large", 0.1f, 100, Color(0.5f))};
  scene.instances = {{0, {}, "small"}, {1, {}, "large"}};
  const named::Glb glb = named::read_glb(write_glb(scene));
  EXPECT_EQ(glb.meshes[0].index_bytes, 2);
  // Eight octants of 101 * 102 / 2 vertices, welded where they meet on the axes' planes, need less than 65 536.
  EXPECT_EQ(glb.meshes[1].position.size(), 4u * 100 * 100 + 2);
  EXPECT_EQ(glb.meshes[1].index_bytes, 2);
  scene.solids[1] = named::ball("larger", 0.1f, 140, Color(0.5f));
  EXPECT_EQ(named::read_glb(write_glb(scene)).meshes[1].index_bytes, 4);
}

/// A strip of `vertices` separate vertices.
Solid strip(std::uint32_t vertices) {
  Solid solid = named::ball("strip", 0.1f, 1, Color(0.5f));
  solid.mesh.position.clear();
  solid.mesh.triangle.clear();
  for (std::uint32_t i = 0; i < vertices; ++i) {
    solid.mesh.position.emplace_back(1e-4f * static_cast<float>(i), i % 2 == 0 ? 0.0f : 1e-3f, 0.0f);
    if (i >= 2) solid.mesh.triangle.emplace_back(i - 2, i % 2 == 0 ? i - 1 : i, i % 2 == 0 ? i : i - 1);
  }
  solid.mesh.normal.assign(vertices, {0, 0, 1});
  solid.mesh.color.assign(vertices, Color(0.5f));
  solid.mesh.part.assign(vertices, 0);
  solid.mesh.cut_face.assign(solid.mesh.triangle.size(), -1);
  solid.mesh.surface.assign(solid.mesh.triangle.size(), 0);
  return solid;
}

/// glTF 2.0, section 3.7.2.1: an index must not be 65 535, which restarts a primitive on many machines.
TEST(Gltf, NoIndexOfTwoBytesRestartsAPrimitive) {
  for (const auto& [vertices, bytes] : {std::pair{65535u, 2}, {65536u, 4}}) {
    Scene scene;
    scene.solids = {strip(vertices)};
    scene.instances = {{0, {}, "strip"}};
    const named::Glb glb = named::read_glb(write_glb(scene));
    ASSERT_EQ(glb.meshes[0].position.size(), vertices);
    EXPECT_EQ(glb.meshes[0].index_bytes, bytes) << vertices;
  }
}

TEST(Gltf, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = named::mixed();
  EXPECT_EQ(write_glb(scene, {.threads = {1}}), write_glb(scene, {.threads = {2}}));
}

/// Solids in groups of three or one by one, spooled to disk or not.
class GltfStream : public testing::TestWithParam<std::size_t> {
 protected:
  /// \param add adds `count` of the scene's solids from `first` on.
  template <typename Add>
  std::string streamed(const Scene& scene, const Add& add, const ExportOptions& options = {}) const {
    const TemporaryFolder folder;
    const auto spool = std::make_shared<SpooledBytes>(folder / "a.glb");
    GlbStream stream(options, spool.get());
    for (std::size_t first = 0; first < scene.solids.size(); first += GetParam())
      add(stream, first, std::min(GetParam(), scene.solids.size() - first));
    Scene shapes = scene;
    for (Solid& solid : shapes.solids) {
      const SolidMesh whole = std::exchange(solid.mesh, {});
      solid.mesh.position = whole.position, solid.mesh.triangle = whole.triangle, solid.mesh.cut_face = whole.cut_face;
    }
    write_whole(std::vector{OutputFile{folder / "a.glb", std::move(stream).finished(shapes), spool}});
    return file_bytes(folder / "a.glb", std::size_t{1} << 30);
  }
};

TEST_P(GltfStream, GivesTheBytesOfTheWhole) {
  Scene scene = named::mixed();
  scene.solids.push_back(named::ball("large", 0.1f, 200, Color(0.5f)));  // more than a block of the buffer
  scene.instances.push_back({static_cast<int>(scene.solids.size()) - 1, {}, "large"});
  std::vector<std::vector<Solid>> levels(scene.solids.size());
  levels[0] = {scene.solids[0]};
  const std::span<const Solid> solids = scene.solids;
  for (const int threads : {1, 2}) {
    const ExportOptions options{.provenance = "x", .threads = {threads}};
    const std::string whole = write_glb(scene, options, levels);
    ASSERT_GT(whole.size(), std::size_t{8} << 20);
    EXPECT_TRUE(streamed(
                    scene,
                    [&](GlbStream& stream, std::size_t first, std::size_t count) {
                      stream.add(solids.subspan(first, count), std::span(levels).subspan(first, count));
                    },
                    options) == whole);
  }
}

TEST_P(GltfStream, GivesTheBytesOfTheWholeWithTextures) {
  Scene scene = named::mixed();
  std::erase_if(scene.solids, [](const Solid& solid) { return solid.mesh.triangle.empty(); });
  scene.instances.clear();
  for (std::size_t i = 0; i < scene.solids.size(); ++i)
    scene.instances.push_back({static_cast<int>(i), {}, scene.solids[i].name});
  const std::span<const Solid> solids = scene.solids;
  const auto in_textures = [](std::span<const Solid> some) {
    return all_baked(some, style_named("plain"), {.texels = 64, .maps = Maps::all});
  };
  const std::string whole = write_glb(scene, in_textures(solids));
  EXPECT_TRUE(streamed(scene, [&](GlbStream& stream, std::size_t first, std::size_t count) {
                stream.add_baked(solids.subspan(first, count), in_textures(solids.subspan(first, count)));
              }) == whole);
}

INSTANTIATE_TEST_SUITE_P(SolidsAtOnce, GltfStream, testing::Values(1, 3, 100));

TEST(Gltf, TexturesTakeThePlaceOfVertexColours) {
  Scene scene;
  scene.solids = {named::box("box", {0, 0, 0}, {0.05f, 0.03f, 0.02f}, {0.8f, 0.05f, 0.05f}, {0.9f, 0.85f, 0.6f})};
  scene.instances = {{0, {}, "box"}};
  const std::vector<BakedSolid> baked_solids = {baked(scene.solids[0], style_named("plain"), {.texels = 64})};
  const named::Glb glb = named::read_glb(write_glb(scene, baked_solids));
  const named::GlbMesh& mesh = glb.meshes.at(0);
  EXPECT_TRUE(mesh.color.empty());
  ASSERT_EQ(mesh.uv.size(), mesh.position.size());

  // The texel under the middle of each triangle has the box's colour there.
  ASSERT_EQ(mesh.texture_side, 64);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const glm::uvec3& c = mesh.triangle[t];
    const glm::vec2 uv = (mesh.uv[c.x] + mesh.uv[c.y] + mesh.uv[c.z]) / 3.0f;
    const std::size_t texel = static_cast<std::size_t>(uv.y * 64) * 64 + static_cast<std::size_t>(uv.x * 64);
    const bool on_top = mesh.normal[c.x].y > 0.5f;
    EXPECT_EQ(mesh.texture[texel], to_srgb8(on_top ? Color(0.9f, 0.85f, 0.6f) : Color(0.8f, 0.05f, 0.05f)));
  }
}

/// The file's JSON: plain text before the buffer.
std::string json_of(const std::string& glb) { return glb.substr(20, glb.find(std::string("BIN\0", 4)) - 24); }
Json parsed(const std::string& glb) { return Json::parse(json_of(glb)); }

/// The node of this name.
Json node_called(const Json& gltf, const std::string& name) {
  for (const Json& node : gltf["nodes"])
    if (node["name"] == name) return node;
  return {};
}

std::vector<std::string> names_of(const Json& things) {
  std::vector<std::string> names;
  for (const Json& thing : things) names.push_back(thing["name"]);
  return names;
}

/// Six boxes of two fruits of an entry, one of another, and a bowl; the first placed twice.
Scene grouped_boxes() {
  Scene scene;
  const auto add = [&](const std::string& entry, int fruit, int piece) {
    const std::string variant = entry + "-" + std::to_string(fruit);
    Solid box = named::box(variant + ".piece-" + std::to_string(piece), {0.1f, 0.2f, 0.3f}, {0.14f, 0.22f, 0.36f},
                           {0.8f, 0, 0}, {0.9f, 0.8f, 0.6f});
    box.origin = {.source = "kiwi",
                  .key = {.seed = 3, .index = 4294967295u},
                  .knives = {"half"},
                  .number = piece,
                  .pieces = 3,
                  .fruit = "kiwi",
                  .entry = entry,
                  .variant = variant};
    scene.solids.push_back(box);
    scene.instances.push_back({static_cast<int>(scene.solids.size()) - 1, {}, box.name});
  };
  for (const int fruit : {1, 2})
    for (const int piece : {1, 2, 3}) add("halves", fruit, piece);
  add("garnish", 1, 2);
  scene.instances.push_back({0, {.rotation = {0, 1, 0, 0}, .translation = {0, 1, 0}}, "halves-1.piece-1.copy-2"});
  scene.solids.push_back(named::ball("bowl", 0.1f, 4, Color(0.5f)));
  scene.instances.push_back({7, {}, "bowl"});
  return scene;
}

TEST(Gltf, APieceTurnsAboutItsCentreAndLiesWhereItLay) {
  const Scene scene = grouped_boxes();
  const std::string bytes = write_glb(scene);
  const named::Glb glb = named::read_glb(bytes);
  const glm::dvec3 center(0.12, 0.21, 0.33);
  EXPECT_LT(glm::length(glm::dvec3(glb.nodes[0].matrix[3]) - center), 5e-8);
  const Json copy = node_called(parsed(bytes), "halves-1.piece-1.copy-2");
  EXPECT_NEAR(copy["translation"][0], 0.12, 5e-8);
  EXPECT_NEAR(copy["translation"][1], 1 - 0.21, 5e-8) << "half a turn about x, and up";
  EXPECT_NEAR(copy["translation"][2], -0.33, 5e-8);
  const Solid& box = scene.solids[0];
  for (std::size_t t = 0; t < box.mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec4 there =
          glb.nodes[0].matrix * glm::dvec4(glb.meshes[0].position[glb.meshes[0].triangle[t][k]], 1);
      EXPECT_LT(glm::length(glm::dvec3(there) - glm::dvec3(box.mesh.position[box.mesh.triangle[t][k]])), 1e-7);
    }
  }
  const Json bowl = node_called(parsed(bytes), "bowl");
  EXPECT_FALSE(bowl.contains("translation")) << "what is no piece keeps its frame";
}

TEST(Gltf, PiecesAreInGroupsByEntryAndFruit) {
  const Json gltf = parsed(write_glb(grouped_boxes()));
  const auto children = [&](const Json& node) {
    std::vector<std::string> names;
    for (const int child : node["children"]) names.push_back(gltf["nodes"][child]["name"]);
    return names;
  };
  Json root;
  root["children"] = gltf["scenes"][0]["nodes"];
  EXPECT_THAT(children(root), ElementsAre("halves", "garnish", "bowl", "view"));
  EXPECT_THAT(children(node_called(gltf, "halves")), ElementsAre("halves-1", "halves-2"));
  EXPECT_THAT(children(node_called(gltf, "halves-1")),
              ElementsAre("halves-1.piece-1", "halves-1.piece-2", "halves-1.piece-3", "halves-1.piece-1.copy-2"));
  EXPECT_THAT(children(node_called(gltf, "garnish")), ElementsAre("garnish-1.piece-2")) << "one piece is no group";
}

TEST(Gltf, SaysHowAPieceIsMadeAgain) {
  const Json gltf = parsed(write_glb(grouped_boxes(), {.command_words = " --style plain"}));
  const Json extras = gltf["meshes"][1]["extras"];
  EXPECT_EQ(extras["template"], "kiwi");
  EXPECT_TRUE(extras["seed"].is_number_integer());
  EXPECT_EQ(extras["seed"], 3);
  EXPECT_EQ(extras["index"], 4294967295u);
  EXPECT_EQ(extras["knife"], "half");
  EXPECT_EQ(extras["piece"], 2);
  EXPECT_EQ(extras["command"],
            "pomona cut kiwi --seed 3 --index 4294967295 --knife half --piece 2 --style plain -o halves-1.piece-2.glb");
  EXPECT_FALSE(gltf["meshes"][7]["extras"].contains("command")) << "nobody cuts a bowl";
}

TEST(Gltf, AFruitsPiecesShareItsMaterialsByName) {
  Scene scene = named::with_materials();
  scene.solids[0].origin = {.number = 1, .fruit = "kiwi"};
  scene.solids.push_back(scene.solids[0]);
  scene.instances.push_back({static_cast<int>(scene.solids.size()) - 1, {}, "another"});
  for (Solid& solid : scene.solids) solid.own_look().on_skin = {1, 0};
  EXPECT_THAT(names_of(parsed(write_glb(scene))["materials"]), ElementsAre("kiwi skin", "kiwi flesh"));

  // The cut face of a part that the skin also shows is another look. A look of several parts is named by its place.
  for (Solid& solid : scene.solids) solid.own_look().on_skin = {1, 1};
  EXPECT_THAT(names_of(parsed(write_glb(scene))["materials"]), ElementsAre("kiwi skin", "kiwi flesh cut"));
  for (Solid& solid : scene.solids) solid.own_look().materials.assign(2, solid.look->materials[1]);
  EXPECT_THAT(names_of(parsed(write_glb(scene))["materials"]), ElementsAre("kiwi outside", "kiwi inside"));
}

TEST(Gltf, InstancesOfAMeshMayBeOneNode) {
  const std::string bytes = write_glb(grouped_boxes(), {.instances = true});
  const Json gltf = parsed(bytes);
  const Json node = node_called(gltf, "halves-1.piece-1");
  const Json attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  EXPECT_EQ(gltf["accessors"][attributes["TRANSLATION"].get<int>()]["count"], 2);
  EXPECT_EQ(gltf["accessors"][attributes["ROTATION"].get<int>()]["type"], "VEC4");
  EXPECT_FALSE(node.contains("translation"));
  EXPECT_EQ(node["extras"]["instances"][1], "halves-1.piece-1.copy-2");
  EXPECT_TRUE(node_called(gltf, "halves-1.piece-1.copy-2").is_null());
  EXPECT_FALSE(gltf.contains("extensionsRequired"));
  EXPECT_EQ(named::read_glb(bytes).meshes.size(), 8u) << "and another reader takes it";
}

TEST(Gltf, PartsMayBeFeatures) {
  const Json gltf = parsed(write_glb(grouped_boxes(), {.feature_ids = true}));
  for (const Json& mesh : gltf["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      EXPECT_EQ(primitive["attributes"]["_FEATURE_ID_0"], primitive["attributes"]["_PART"]);
      const Json feature = primitive["extensions"]["EXT_mesh_features"]["featureIds"][0];
      EXPECT_EQ(feature["attribute"], 0);
      EXPECT_EQ(feature["featureCount"], mesh["extras"]["parts"].size());
    }
  }
  EXPECT_FALSE(gltf.contains("extensionsRequired"));
}

TEST(Gltf, EnginesFindHullsAndLevelsByTheirNames) {
  const Scene scene = grouped_boxes();
  std::vector<std::vector<Solid>> levels(scene.solids.size());
  levels[0] = {scene.solids[0]};
  const auto written = [&](Engine engine) { return parsed(write_glb(scene, {.engine = engine}, levels)); };

  const Json godot = written(Engine::godot);
  const Json piece = node_called(godot, "halves-1_piece-1");
  ASSERT_EQ(piece["children"].size(), 1u);
  const Json hull = godot["nodes"][piece["children"][0].get<int>()];
  EXPECT_EQ(hull["name"], "halves-1_piece-1-convcolonly");
  const Json position = godot["meshes"][hull["mesh"].get<int>()]["primitives"][0]["attributes"]["POSITION"];
  EXPECT_EQ(godot["accessors"][position.get<int>()]["count"], 8);
  EXPECT_NEAR(godot["accessors"][position.get<int>()]["max"][0], 0.02, 1e-8) << "in the frame of the piece's mesh";

  const Json unreal = written(Engine::unreal);
  EXPECT_THAT(names_of(unreal["meshes"]),
              testing::IsSupersetOf({"halves-1_piece-1_LOD0", "halves-1_piece-1_LOD1", "UCX_halves-1_piece-1_LOD0_00",
                                     "halves-1_piece-2", "UCX_halves-1_piece-2_00"}));
  const Json unity = written(Engine::unity);
  EXPECT_THAT(names_of(unity["nodes"]), testing::IsSupersetOf({"halves-1_piece-1_LOD0", "halves-1_piece-1_LOD1"}));
  EXPECT_EQ(unity["meshes"].size(), 9u) << "no hulls: Unity makes its own";
  for (const std::string& name : names_of(unity["nodes"])) EXPECT_THAT(name, testing::Not(testing::HasSubstr(".")));
}

Json mesh_of(const Json& gltf, const std::string& node) {
  return gltf["meshes"][node_called(gltf, node)["mesh"].get<int>()];
}

TEST(Gltf, DishesCollideByTheirTrianglesOrByParts) {
  Scene scene = named::mixed();
  scene.instances.resize(1);
  scene.solids[0].origin = {};
  const Json godot = parsed(write_glb(scene, {.engine = Engine::godot}));
  const Json dish = node_called(godot, scene.instances[0].name);
  ASSERT_EQ(dish["children"].size(), 1u);
  const Json shape = godot["nodes"][dish["children"][0].get<int>()];
  EXPECT_EQ(shape["name"], scene.instances[0].name + "-colonly");
  EXPECT_NE(shape["mesh"], dish["mesh"]) << "Godot would take the dish that is seen for a second one to collide with";
  const Json of_shape = mesh_of(godot, shape["name"])["primitives"], seen = mesh_of(godot, dish["name"])["primitives"];
  ASSERT_EQ(of_shape.size(), seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(of_shape[i]["indices"], seen[i]["indices"]) << "no bytes for it";
    EXPECT_EQ(of_shape[i]["attributes"]["POSITION"], seen[i]["attributes"]["POSITION"]);
    EXPECT_EQ(of_shape[i]["attributes"].size(), 1u) << "nobody sees it";
  }
  const Json unreal = parsed(write_glb(scene, {.engine = Engine::unreal}));
  EXPECT_THAT(names_of(unreal["nodes"]), testing::Contains("UCX_" + scene.instances[0].name + "_00"));
}

/// How deep shapes of two neighbours of settled_balls() lie within each other, metres; of their nodes' names.
double depth_of_balls(const Json& gltf, const std::string& left, const std::string& right) {
  const auto position = [&](const std::string& name) {
    return gltf["accessors"][mesh_of(gltf, name)["primitives"][0]["attributes"]["POSITION"].get<int>()];
  };
  EXPECT_NEAR(position(left)["min"][0], -0.01, 1e-6);
  return position(left)["max"][0].get<double>() - 0.018 - position(right)["min"][0].get<double>();
}

TEST(Gltf, ShapesOfSettledPiecesLeaveRoomForEachOther) {
  const Json godot = parsed(write_glb(named::settled_balls(), {.engine = Engine::godot}));
  EXPECT_LE(depth_of_balls(godot, "ball-1-convcolonly", "ball-2-convcolonly"), 1e-4);
  EXPECT_LE(depth_of_balls(godot, "ball-3-convcolonly", "ball-4-convcolonly"), 1e-4);
  EXPECT_EQ(godot["meshes"].size(), 7u) << "none is there in vain";
}

/// Unreal's shapes belong to a mesh, which it finds by the name. So copies with shapes of their own have such meshes.
TEST(Gltf, UnrealsCopiesLeaveRoomForEachOther) {
  Scene scene = named::settled_balls();
  for (const double away : {1.0, 2.0})
    scene.instances.push_back({2,
                               {.rotation = {1, 0, 0, 0}, .translation = {away, 0, 0}},
                               "ball-" + std::to_string(scene.instances.size() + 1)});
  const std::vector<std::vector<Solid>> levels{{}, {}, {scene.solids[2]}};
  for (const bool has_levels : {false, true}) {
    const std::string end = has_levels ? "_LOD0" : "";
    const Json gltf =
        parsed(write_glb(scene, {.engine = Engine::unreal}, has_levels ? levels : std::vector<std::vector<Solid>>()));
    EXPECT_LE(depth_of_balls(gltf, "UCX_ball-1_00", "UCX_ball-2_00"), 1e-4);
    EXPECT_LE(depth_of_balls(gltf, "UCX_ball-3" + end + "_00", "UCX_ball-4" + end + "_00"), 1e-4);

    // All have the same arrays; those with room have the same mesh.
    for (const char* ball : {"ball-4", "ball-5"}) {
      EXPECT_NE(node_called(gltf, ball + end)["mesh"], node_called(gltf, "ball-3" + end)["mesh"]);
      EXPECT_EQ(mesh_of(gltf, ball + end)["primitives"], mesh_of(gltf, "ball-3" + end)["primitives"]);
      EXPECT_EQ(mesh_of(gltf, ball + end)["name"], ball + end);
    }
    EXPECT_EQ(node_called(gltf, "ball-5" + end)["mesh"], node_called(gltf, "ball-6" + end)["mesh"]);
    EXPECT_EQ(gltf["meshes"].size(), has_levels ? 11u : 10u) << "none is there in vain";

    // What importers go by: each mesh has one name, and one set of shapes, which are named after it.
    const std::vector<std::string> names = names_of(gltf["meshes"]);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    for (const Json& node : gltf["nodes"]) {
      if (!node.contains("children") || !node.contains("mesh")) continue;
      const Json shape = gltf["nodes"][node["children"][0].get<int>()];
      const auto name_of = [&](const Json& of) {
        return gltf["meshes"][of["mesh"].get<int>()]["name"].get<std::string>();
      };
      EXPECT_EQ(name_of(shape), "UCX_" + name_of(node) + "_00");
    }
  }
}

/// On an atlas triangles stand in another order, which would divide a piece otherwise: here one shows which is asked.
TEST(Gltf, ShapesAreThoseOfTheSolidWithTexturesToo) {
  const Scene scene = named::settled_balls();
  std::vector<BakedSolid> baked;
  for (const Solid& solid : scene.solids) {
    BakedSolid one{.solid = solid, .uv = {}, .texture = {1, 1, {glm::u8vec3(9)}}};
    one.uv.resize(solid.mesh.position.size(), {0.25f, 0.25f});
    for (glm::vec3& p : one.solid.mesh.position) p *= 0.5f;
    baked.push_back(std::move(one));
  }
  const Json gltf = parsed(write_glb(scene, baked, {.engine = Engine::godot}));
  const Json hull = gltf["meshes"][node_called(gltf, "ball-4-convcolonly")["mesh"].get<int>()];
  const Json position = gltf["accessors"][hull["primitives"][0]["attributes"]["POSITION"].get<int>()];
  EXPECT_NEAR(position["max"][0], 0.01, 1e-6);
}

TEST(Gltf, ForBlenderLevelsLieSideBySide) {
  const Scene scene = grouped_boxes();
  std::vector<std::vector<Solid>> levels(scene.solids.size());
  levels[0] = {scene.solids[0], scene.solids[0]};
  const auto places = static_cast<std::size_t>(
      std::count_if(scene.instances.begin(), scene.instances.end(), [](const Instance& i) { return i.solid == 0; }));
  const std::string bytes = write_glb(scene, {.engine = Engine::blender}, levels);
  EXPECT_THAT(json_of(bytes), testing::Not(testing::HasSubstr("MSFT_lod")));
  const Json glb = parsed(bytes);
  double before = 0;
  for (const char* name : {"LOD1", "LOD2"}) {
    const Json group = node_called(glb, name);
    EXPECT_EQ(group["children"].size(), places) << "one for each place of the solid that has levels";
    const double away = group["translation"][0].get<double>();
    EXPECT_GT(away - before, 0.02) << "farther than the scene is wide";
    before = away;
  }
}

TEST(Gltf, SaysMaterialsInExtensionsThatNobodyMustKnow) {
  const std::string json = json_of(write_glb(named::with_materials()));
  for (const char* name : {"KHR_materials_clearcoat", "KHR_materials_sheen", "KHR_materials_specular",
                           "KHR_materials_diffuse_transmission"}) {
    EXPECT_THAT(json, ::testing::HasSubstr(name));
  }
  EXPECT_THAT(json, ::testing::HasSubstr("extensionsUsed"));
  EXPECT_THAT(json, ::testing::Not(::testing::HasSubstr("extensionsRequired")));
  EXPECT_THAT(json_of(write_glb(named::mixed())), ::testing::Not(::testing::HasSubstr("extensions")));
}

TEST(Gltf, TellsLightUnderTheSurfaceBesideTexturesAlone) {
  Scene scene = named::with_materials();
  MaterialSketch& flesh = scene.solids[0].own_look().materials[1];
  flesh.subsurface = Subsurface{.radius = 0.004, .tint = {1, 0.5f, 0.25f}, .weight = 0.7};
  EXPECT_THAT(json_of(write_glb(scene)), testing::Not(testing::HasSubstr("subsurface")));
  const Json textured =
      parsed(write_glb(scene, std::vector{baked(scene.solids[0], style_named("plain"), {.texels = 64})}));
  Json inside;
  for (const Json& material : textured["materials"]) {
    const Json told = material.value("extras", Json::object()).value("subsurface", Json::object());
    if (told.value("weight", 0.0) == 0.7) inside = told;
  }
  ASSERT_TRUE(inside.is_object());
  EXPECT_NEAR(inside["radius"][0].get<double>(), 0.004, 1e-9);
  EXPECT_NEAR(inside["radius"][1].get<double>(), 0.002, 1e-9);

  // Straight transmission needs an extension that the files did not use yet.
  flesh.transmission = 0.25;
  EXPECT_THAT(json_of(write_glb(scene)), testing::HasSubstr("KHR_materials_transmission"));
}

TEST(Gltf, HasMapsInTheirSlotsWhereTheyWereBaked) {
  const Scene scene = named::with_materials();
  const auto written = [&](Maps maps) {
    return parsed(
        write_glb(scene, std::vector{baked(scene.solids[0], style_named("plain"), {.texels = 64, .maps = maps})}));
  };
  const Json color = written(Maps::color), all = written(Maps::all);
  EXPECT_EQ(color["textures"].size(), 1u);
  EXPECT_EQ(all["textures"].size(), 4u);
  EXPECT_FALSE(all.contains("extensionsRequired"));
  ASSERT_EQ(all["samplers"].size(), 1u) << "one for all textures";
  for (const Json& texture : all["textures"]) EXPECT_EQ(texture["sampler"], 0);
  for (const Json& material : color["materials"]) EXPECT_FALSE(material.contains("normalTexture"));
  bool any_volume = false;
  for (const Json& material : all["materials"]) {
    const auto name_of = [&](const Json& slot) {
      return all["textures"][slot["index"].get<int>()]["name"].get<std::string>();
    };
    EXPECT_EQ(name_of(material["normalTexture"]), "box normal");
    EXPECT_EQ(name_of(material["occlusionTexture"]), "box orm");
    EXPECT_EQ(name_of(material["pbrMetallicRoughness"]["metallicRoughnessTexture"]), "box orm");
    EXPECT_EQ(material["pbrMetallicRoughness"]["roughnessFactor"], 1.0);
    if (!material.contains("extensions") || !material["extensions"].contains("KHR_materials_volume")) continue;
    any_volume = true;
    const Json& volume = material["extensions"]["KHR_materials_volume"];
    EXPECT_EQ(name_of(volume["thicknessTexture"]), "box thickness");
    EXPECT_NEAR(volume["attenuationDistance"].get<double>(), 0.004, 2e-4) << "the depth of its translucency";
  }
  EXPECT_TRUE(any_volume);
  EXPECT_TRUE(all["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
  EXPECT_FALSE(color["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
}

/// A corner of a cut face belongs to a dry part of the same colour: there the film of juice ends softly.
TEST(Gltf, SaysWhereAFilmOfJuiceEnds) {
  Scene scene = named::with_materials();
  Solid& box = scene.solids[0];
  for (MaterialSketch& material : box.own_look().materials) material.wet = 2;
  const auto films = [&] {
    const Json glb =
        parsed(write_glb(scene, std::vector{baked(box, style_named("plain"), {.texels = 64, .maps = Maps::all})}));
    std::vector<std::string> names;
    for (const Json& material : glb["materials"]) {
      const Json::json_pointer film("/extensions/KHR_materials_clearcoat/clearcoatTexture/index");
      if (material.contains(film)) names.push_back(glb["textures"][material[film].get<std::size_t>()]["name"]);
    }
    return names;
  };
  EXPECT_THAT(films(), ::testing::IsEmpty());

  MaterialSketch dry;
  dry.wet = 0;
  const auto rind = static_cast<std::int32_t>(box.look->part_names.size());
  box.own_look().part_names.emplace_back("rind");
  box.own_look().materials.resize(box.look->part_names.size(), dry);
  box.own_look().materials.back() = dry;
  const auto cut =
      std::find_if(box.mesh.cut_face.begin(), box.mesh.cut_face.end(), [](std::int32_t face) { return face >= 0; });
  ASSERT_NE(cut, box.mesh.cut_face.end());
  std::uint32_t& corner = box.mesh.triangle[static_cast<std::size_t>(cut - box.mesh.cut_face.begin())].x;
  box.mesh.position.push_back(box.mesh.position[corner]);
  box.mesh.normal.push_back(box.mesh.normal[corner]);
  box.mesh.color.push_back(box.mesh.color[corner]);
  box.mesh.part.push_back(rind);
  corner = static_cast<std::uint32_t>(box.mesh.position.size()) - 1;
  EXPECT_THAT(films(), ::testing::Contains("box thickness"));
}

/// The texel in the middle of a triangle.
std::size_t texel_at_middle(const BakedSolid& solid, const glm::uvec3& t) {
  const glm::vec2 uv = (solid.uv[t.x] + solid.uv[t.y] + solid.uv[t.z]) / 3.0f;
  const int side = solid.texture.width;
  return static_cast<std::size_t>(uv.y * static_cast<float>(side)) * static_cast<std::size_t>(side) +
         static_cast<std::size_t>(uv.x * static_cast<float>(side));
}

TEST(Gltf, MapsTellTheLooksOfParts) {
  const Scene scene = named::with_materials();
  const Solid& box = scene.solids[0];
  const BakedSolid made = baked(box, style_named("plain"), {.texels = 128, .maps = Maps::all, .looks = true});
  int coated = 0, dull = 0, hairy = 0, lit = 0;
  for (std::size_t t = 0; t < made.solid.mesh.triangle.size(); ++t) {
    const glm::uvec3& corners = made.solid.mesh.triangle[t];
    const MaterialSketch material = material_of(box, made.solid.mesh.part[corners.x]);
    const PbrMaterial look = look_of(material, made.solid.mesh.cut_face[t] >= 0);
    const std::size_t at = texel_at_middle(made, corners);
    EXPECT_NEAR(made.maps.coat.image.pixels[at].r / 255.0, look.clearcoat, 0.003);
    EXPECT_NEAR(made.maps.coat.image.pixels[at].g / 255.0, look.clearcoat_roughness, 0.003);
    EXPECT_NEAR(made.maps.coat.opacity[at] / 255.0, look.specular, 0.003);
    // Not 0 where there is none: three.js drew black there.
    EXPECT_NEAR(made.maps.sheen.opacity[at] / 255.0, look.sheen_roughness > 0 ? look.sheen_roughness : 1, 0.003);
    EXPECT_NEAR(static_cast<double>(from_srgb8(made.maps.sheen.image.pixels[at]).r), look.sheen[0], 0.01);
    EXPECT_NEAR(made.maps.light.opacity[at] / 255.0, look.transmission, 0.003);
    const double blue = static_cast<double>(from_srgb8(made.maps.light.image.pixels[at]).b);
    EXPECT_NEAR(blue, look.transmission > 0 ? look.transmission_color[2] : 1, 0.01);
    if (look.clearcoat > 0) ++coated;
    if (look.specular < 1) ++dull;
    if (look.sheen_roughness > 0) ++hairy;
    if (look.transmission > 0) ++lit;
  }
  EXPECT_TRUE(coated > 0 && dull > 0 && hairy > 0 && lit > 0) << "something to tell apart";
}

TEST(Gltf, HasOneMaterialForAPieceWhoseMapsTellLooks) {
  Scene scene = named::with_materials();
  const auto written = [&] {
    return parsed(write_glb(scene, std::vector{baked(scene.solids[0], style_named("plain"),
                                                     {.texels = 64, .maps = Maps::all, .looks = true})}));
  };
  const Json glb = written();
  ASSERT_EQ(glb["materials"].size(), 1u);
  ASSERT_EQ(glb["meshes"][0]["primitives"].size(), 1u);
  EXPECT_TRUE(glb["meshes"][0]["primitives"][0]["attributes"].contains("_PART")) << "parts stay known";
  EXPECT_FALSE(glb.contains("extensionsRequired"));
  const Json& material = glb["materials"][0];
  EXPECT_EQ(material["name"], "box");
  const auto name_at = [&](const char* slot) {
    const Json::json_pointer pointer(std::string("/extensions/KHR_materials_") + slot + "/index");
    return material.contains(pointer) ? glb["textures"][material[pointer].get<std::size_t>()]["name"].get<std::string>()
                                      : std::string();
  };
  EXPECT_EQ(name_at("clearcoat/clearcoatTexture"), "box coat");
  EXPECT_EQ(name_at("clearcoat/clearcoatRoughnessTexture"), "box coat");
  EXPECT_EQ(name_at("specular/specularTexture"), "box coat");
  EXPECT_EQ(name_at("sheen/sheenColorTexture"), "box sheen");
  EXPECT_EQ(name_at("diffuse_transmission/diffuseTransmissionTexture"), "box light");

  // What light goes straight through is drawn by itself.
  const std::size_t triangles = scene.solids[0].mesh.triangle.size();
  scene.solids[0].own_look().materials[1].transmission = 0.25;
  const Json clear = written();
  ASSERT_EQ(clear["materials"].size(), 2u);
  EXPECT_EQ(clear["materials"][1]["name"], "box clear");
  std::size_t corners = 0;
  for (const Json& primitive : clear["meshes"][0]["primitives"])
    corners += clear["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>();
  EXPECT_EQ(corners, 3 * triangles);
}

/// Pieces whose textures are on one page: a material, and a texture for each map, however many pieces.
TEST(Gltf, HasOneMaterialForAllPiecesOfAPage) {
  Scene scene;
  std::vector<BakedSolid> alone;
  for (const char* name : {"a", "b", "c"}) {
    Solid solid = named::with_materials().solids[0];
    solid.name = name;
    solid.own_look().materials[1].wet = 0.5 * static_cast<double>(alone.size());
    scene.instances.push_back({static_cast<int>(alone.size()), {}, name});
    alone.push_back(baked(solid, style_named("plain"), {.texels = 64, .maps = Maps::all, .looks = true}));
    scene.solids.push_back(std::move(solid));
  }
  const std::vector<const BakedSolid*> all{&alone[0], &alone[1], &alone[2]};
  const std::vector<glm::ivec2> sizes(3, glm::ivec2(64));
  const std::vector<BakedSolid> paged = on_pages(all, page_layout(sizes), "atlas");
  const Json glb = parsed(write_glb(scene, paged));
  EXPECT_EQ(glb["meshes"].size(), 3u);
  for (const Json& mesh : glb["meshes"]) EXPECT_EQ(mesh["primitives"].size(), 1u);
  ASSERT_EQ(glb["materials"].size(), 1u);
  EXPECT_EQ(glb["materials"][0]["name"], "atlas");
  std::vector<std::string> names;
  for (const Json& texture : glb["textures"]) names.push_back(texture["name"]);
  EXPECT_THAT(names, ElementsAre("atlas", "atlas normal", "atlas orm", "atlas coat", "atlas sheen", "atlas light"));
  EXPECT_EQ(glb["images"].size(), 6u);

  // Of another colour it is another page, at the same places.
  const std::vector<TextureVariant> variants{{"ripeness 0", on_pages(all, page_layout(sizes), "atlas")}};
  const Json with_variant = parsed(write_glb(scene, paged, {}, {}, variants));
  EXPECT_EQ(with_variant["materials"].size(), 2u);
}

/// Colours of vertices: each corner lies on texels that say what the material of its look says.
TEST(Gltf, APaletteTellsTheLooksOfVerticesWithColours) {
  const Scene scene = named::with_materials();
  const StyledMesh mesh = styled_meshes(scene, {})[0];
  const std::vector<MaterialGroup> groups = groups_by_material(scene.solids[0], mesh);
  LookPalette palette;
  const MeshOnPalette placed = on_palette(mesh, groups, palette);
  ASSERT_EQ(placed.groups.size(), 1u);
  ASSERT_EQ(placed.mesh.triangle.size(), mesh.triangle.size());
  const SurfaceMaps maps = palette.maps();
  ASSERT_EQ(groups.size(), 2u);
  for (const MaterialGroup& group : groups) {
    for (const std::int32_t face : group.face) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t vertex = placed.mesh.triangle[static_cast<std::size_t>(face)][k];
        const std::uint32_t before = mesh.triangle[static_cast<std::size_t>(face)][k];
        EXPECT_EQ(placed.mesh.position[vertex], mesh.position[before]);
        EXPECT_EQ(placed.mesh.color[vertex], mesh.color[before]);
        const glm::ivec2 texel(placed.mesh.look_place[vertex] * static_cast<float>(maps.orm.width));
        EXPECT_NEAR(maps.orm.at(texel.x, texel.y).g / 255.0, group.look.roughness, 0.002);
        EXPECT_NEAR(maps.coat.image.at(texel.x, texel.y).r / 255.0, group.look.clearcoat, 0.002);
        EXPECT_NEAR(from_srgb8(maps.sheen.image.at(texel.x, texel.y)).r, group.look.sheen[0], 0.01);
        const auto at = static_cast<std::size_t>(texel.y * maps.light.image.width + texel.x);
        EXPECT_NEAR(maps.light.opacity[at] / 255.0, group.look.transmission, 0.002);
      }
    }
  }
}

/// Two looks may share a vertex: both have one.
TEST(Gltf, APaletteDoublesVerticesOfTwoLooks) {
  StyledMesh mesh;
  mesh.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangle = {{0, 1, 2}, {1, 3, 2}};
  std::vector<MaterialGroup> groups{
      {.look = {.roughness = 0.2}, .name = "a", .face = {0}, .triangle = {mesh.triangle[0]}},
      {.look = {.roughness = 0.8}, .name = "b", .face = {1}, .triangle = {mesh.triangle[1]}}};
  LookPalette palette;
  const MeshOnPalette placed = on_palette(mesh, groups, palette);
  EXPECT_EQ(placed.mesh.position.size(), 6u);
  for (std::size_t t = 0; t < 2; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(placed.mesh.look_place[placed.mesh.triangle[t][k]], palette.place_of(groups[t].look));
}

TEST(Gltf, HasOneMaterialForVerticesWithColoursIfAsked) {
  Scene scene = named::with_materials();
  scene.solids.push_back(scene.solids[0]);
  scene.solids[1].name = "other";
  scene.instances.push_back({1, {}, "other"});
  const std::size_t by_look = parsed(write_glb(scene))["materials"].size();
  EXPECT_GT(by_look, 2u);
  const Json by_piece = parsed(write_glb(scene, {.atlas = AtlasOf::piece}));
  const Json by_file = parsed(write_glb(scene, {.compress = Compression::meshopt, .atlas = AtlasOf::file}));
  EXPECT_EQ(by_piece["materials"].size(), 2u);
  EXPECT_EQ(by_file["materials"].size(), 1u);
  for (const Json& glb : {by_piece, by_file}) {
    for (const Json& mesh : glb["meshes"]) {
      ASSERT_EQ(mesh["primitives"].size(), 1u);
      for (const char* attribute : {"COLOR_0", "TEXCOORD_0", "_PART"})
        EXPECT_TRUE(mesh["primitives"][0]["attributes"].contains(attribute));
    }
    std::vector<std::string> names;
    for (const Json& texture : glb["textures"]) names.push_back(texture["name"]);
    EXPECT_THAT(names, ElementsAre("looks orm", "looks coat", "looks sheen", "looks light"));
    for (const Json& material : glb["materials"]) {
      EXPECT_TRUE(material["pbrMetallicRoughness"].contains("metallicRoughnessTexture"));
      EXPECT_FALSE(material["pbrMetallicRoughness"].contains("baseColorTexture"));
    }
  }
}

TEST(Gltf, SplitsAMeshByLookAndLosesNoTriangle) {
  const Scene scene = named::with_materials();
  const StyledMesh mesh = styled_meshes(scene, {})[0];
  const std::vector<MaterialGroup> groups = groups_by_material(scene.solids[0], mesh);
  ASSERT_EQ(groups.size(), 2u) << "skin and cut face";
  EXPECT_EQ(groups[0].triangle.size() + groups[1].triangle.size(), mesh.triangle.size());
  EXPECT_NE(groups[0].look, groups[1].look);
  EXPECT_EQ(named::read_glb(write_glb(scene)).meshes.size(), 1u);
  Solid plain = scene.solids[0];
  plain.own_look().materials.clear();
  EXPECT_EQ(groups_by_material(plain, mesh).size(), 1u);
}

TEST(Gltf, VariantsAreTexturesOfTheSameMesh) {
  Scene scene;
  scene.solids = {named::box("box", {0, 0, 0}, {0.05f, 0.03f, 0.02f}, {0.8f, 0.05f, 0.05f}, {0.9f, 0.85f, 0.6f})};
  scene.instances = {{0, {}, "box"}};
  Solid green = scene.solids[0];
  for (Color& color : green.mesh.color) color = {0.1f, 0.6f, 0.1f};
  const Style style = style_named("plain");
  const std::vector<BakedSolid> as_it_is = {baked(scene.solids[0], style, {.texels = 64})};
  const std::vector<TextureVariant> variants{{"ripeness 0", {baked(green, style, {.texels = 64})}},
                                             {"ripeness 1", as_it_is}};
  const Json gltf = parsed(write_glb(scene, as_it_is, {}, {}, variants));
  EXPECT_THAT(names_of(gltf["extensions"]["KHR_materials_variants"]["variants"]),
              ElementsAre("ripeness 0", "ripeness 1"));
  EXPECT_EQ(gltf["images"].size(), 3u);
  ASSERT_EQ(gltf["meshes"].size(), 1u);
  const Json primitive = gltf["meshes"][0]["primitives"][0];
  const Json mappings = primitive["extensions"]["KHR_materials_variants"]["mappings"];
  ASSERT_EQ(mappings.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(mappings[i]["variants"], Json::array({i}));
    EXPECT_NE(mappings[i]["material"], primitive["material"]);
  }
  EXPECT_EQ(gltf["materials"][mappings[0]["material"].get<int>()]["name"], "box ripeness 0");
  EXPECT_FALSE(gltf.contains("extensionsRequired"));

  BakedSolid elsewhere = as_it_is[0];
  elsewhere.uv[0].x += 0.1f;
  const std::vector<TextureVariant> wrong{{"x", {elsewhere}}};
  EXPECT_THROW(write_glb(scene, as_it_is, {}, {}, wrong), Error);
}

TEST(Gltf, AnEmptySceneIsStillAFile) {
  const named::Glb glb = named::read_glb(write_glb(Scene{}));
  EXPECT_TRUE(glb.meshes.empty());
  EXPECT_EQ(glb.nodes.size(), 1u);
}

TEST(Gltf, RefusesMorePartsThanANumberOfTwoBytesCanTell) {
  Scene scene = named::mixed();
  scene.solids[0].own_look().part_names.resize(65536);
  EXPECT_NO_THROW(write_glb(scene));
  scene.solids[0].own_look().part_names.resize(65537);
  EXPECT_THROW(write_glb(scene), Error);
}

TEST(Gltf, LongerHairsAreABrighterSheen) {
  MaterialSketch fuzzy;
  EXPECT_EQ(look_of(fuzzy, false).sheen, (std::array<double, 3>{}));
  double before = 0;
  for (const double millimetres : {0.5, 1.0, 2.0, 4.0}) {
    fuzzy.fuzz = {.length = 1e-3 * millimetres, .density = 0.5};
    const double sheen = look_of(fuzzy, false).sheen[0];
    EXPECT_GT(sheen, before) << millimetres;
    before = sheen;
  }
  EXPECT_LT(before, 1);
}

/// Also of hulls, which only have positions.
TEST(Gltf, AccessorsLieWithinTheirViewsAndTheseWithinTheFile) {
  const std::map<std::string, std::size_t> numbers{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const std::map<int, std::size_t> bytes{{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
  for (const Engine engine : {Engine::any, Engine::unreal}) {
    const Json glb = parsed(write_glb(named::mixed(), {.engine = engine}));
    for (const Json& accessor : glb["accessors"]) {
      const Json& view = glb["bufferViews"][accessor["bufferView"].get<int>()];
      const std::size_t element =
          numbers.at(accessor["type"].get<std::string>()) * bytes.at(accessor["componentType"].get<int>());
      const std::size_t stride = view.value("byteStride", element), count = accessor["count"].get<std::size_t>();
      EXPECT_LE(accessor.value("byteOffset", std::size_t{0}) + (count - 1) * stride + element,
                view["byteLength"].get<std::size_t>());
    }
    for (const Json& view : glb["bufferViews"])
      EXPECT_LE(view.value("byteOffset", std::size_t{0}) + view["byteLength"].get<std::size_t>(),
                glb["buffers"][0]["byteLength"].get<std::size_t>());
  }
}

}  // namespace
}  // namespace pomona
