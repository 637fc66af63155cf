// Contents of .glb files besides meshes at nodes are read as viewers show them, or reported by name.
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/mesh/box.h"
#include "generator/surface/file/glb_file.h"
#include "tests/surface/mesh_files.h"

namespace pomona {
namespace {

using namespace mesh_files;
using ::testing::HasSubstr;

std::string message_of(const std::string& bytes, const std::string& object = "") {
  try {
    parse_glb(bytes, "x.glb", object);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return error.what();
  }
  return "no error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// One triangle, followed by values: each list of floats has an accessor of its own.
struct Extra {
  std::string type;
  std::vector<float> values;
};

std::string triangle_glb(const std::string& nodes, const std::string& mesh, const std::vector<Extra>& extras,
                         const std::string& more = "") {
  std::vector<Extra> all{{"VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0}}};
  all.insert(all.end(), extras.begin(), extras.end());
  std::string bin, views, accessors;
  for (const Extra& extra : all) {
    const std::size_t width = extra.type == "VEC3" ? 3 : extra.type == "VEC4" ? 4 : extra.type == "MAT4" ? 16 : 1;
    const std::string index = std::to_string(&extra - all.data());
    views += (views.empty() ? "" : ",") + std::string(R"({"buffer":0,"byteOffset":)") + std::to_string(bin.size()) +
             R"(,"byteLength":)" + std::to_string(4 * extra.values.size()) + "}";
    accessors += (accessors.empty() ? "" : ",") + std::string(R"({"bufferView":)") + index +
                 R"(,"componentType":5126,"count":)" + std::to_string(extra.values.size() / width) + R"(,"type":")" +
                 extra.type + "\"}";
    for (const float value : extra.values) bin.append(reinterpret_cast<const char*>(&value), 4);
  }
  return glb(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + R"(],"meshes":[)" +
                 mesh + R"(],"buffers":[{"byteLength":)" + std::to_string(bin.size()) + R"(}],"bufferViews":[)" +
                 views + R"(],"accessors":[)" + accessors + "]" + more + "}",
             bin);
}
const std::string plain_mesh = R"({"name":"data","primitives":[{"attributes":{"POSITION":0}}]})";

TEST(GlbDialect, WhatIsRequiredAndUnknownIsRefusedByName) {
  const auto requiring = [](const std::string& name) {
    return glb(replaced(cube_json(), "\"scene\":0", "\"extensionsRequired\":[\"" + name + "\"],\"scene\":0"),
               cube_bin());
  };
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "MPEG_scene_dynamic", "X_odd"})
    EXPECT_THAT(message_of(requiring(name)), HasSubstr("requires \"" + std::string(name) + "\""));
  for (const char* name : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization", "EXT_texture_webp"})
    EXPECT_EQ(message_of(requiring(name)), "no error");
}

TEST(GlbDialect, CompressionThatIsNotRequiredIsNamedWhereNothingElseIsThere) {
  const std::string meshopt =
      replaced(cube_json(), "\"buffers\":[{\"byteLength\":200}]",
               "\"buffers\":[{\"byteLength\":200},{\"byteLength\":999,\"extensions\":{\"EXT_meshopt_compression\":"
               "{\"fallback\":true}}}]");
  EXPECT_THAT(message_of(glb(meshopt, cube_bin())), HasSubstr("EXT_meshopt_compression"));
  const std::string draco = replaced(
      replaced(cube_json(), "\"indices\":2", "\"indices\":2,\"extensions\":{\"KHR_draco_mesh_compression\":{}}"),
      "{\"bufferView\":2,\"componentType\"", "{\"componentType\"");
  EXPECT_THAT(message_of(glb(draco, cube_bin())), HasSubstr("KHR_draco_mesh_compression"));
  const std::string both =
      replaced(cube_json(), "\"indices\":2", "\"indices\":2,\"extensions\":{\"KHR_draco_mesh_compression\":{}}");
  EXPECT_EQ(message_of(glb(both, cube_bin())), "no error");
}

TEST(GlbDialect, BytesMayLieInTheJsonBesideAnEmptyChunk) {
  const std::string json =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
      R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
  EXPECT_EQ(parse_glb(glb(json, ""), "x", "").position[1], glm::dvec3(1, 0, 0));
}

TEST(GlbDialect, InstancesAreAllRead) {
  const std::string node = R"({"mesh":0,"translation":[0,5,0],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)"
                           R"({"TRANSLATION":1,"SCALE":2}}}})";
  const PlainMesh mesh = parse_glb(
      triangle_glb(node, plain_mesh, {{"VEC3", {0, 0, 0, 10, 0, 0}}, {"VEC3", {1, 1, 1, 2, 2, -2}}}), "x", "");
  ASSERT_EQ(mesh.triangle.size(), 2u);
  EXPECT_EQ(mesh.position[3], glm::dvec3(10, 5, 0));
  // The second is mirrored: it would show its back unless two of its corners are exchanged.
  EXPECT_EQ(mesh.position[4], glm::dvec3(10, 7, 0));
  EXPECT_EQ(mesh.position[5], glm::dvec3(12, 5, 0));
}

TEST(GlbDialect, WhatIsMadeInvisibleIsNotThere) {
  const std::string nodes =
      R"({"children":[1,2]},{"mesh":0,"extensions":{"KHR_node_visibility":{"visible":false}}},{"mesh":0})";
  EXPECT_EQ(parse_glb(triangle_glb(nodes, plain_mesh, {}), "x", "").triangle.size(), 1u);
}

TEST(GlbDialect, SkinsArePlacedByTheirJoints) {
  // The node's own scale does not count; the joint's does.
  const std::string nodes =
      R"({"children":[1,2]},{"mesh":0,"skin":0,"scale":[100,100,100]},{"translation":[0,0,3],"scale":[2,2,2]})";
  const std::string mesh = R"({"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}}]})";
  std::string bytes = triangle_glb(
      nodes, mesh, {{"VEC4", std::vector<float>(12, 0)}, {"VEC4", {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0.5f, 0, 0, 0}}},
      R"(,"skins":[{"joints":[2]}])");
  const PlainMesh posed = parse_glb(bytes, "x", "");
  EXPECT_EQ(posed.position[0], glm::dvec3(0, 0, 3));
  EXPECT_EQ(posed.position[1], glm::dvec3(2, 0, 3));
  EXPECT_EQ(posed.position[2], glm::dvec3(0, 2, 3));
  EXPECT_THAT(message_of(replaced(bytes, R"("joints":[2])", R"("joints":[7])")), HasSubstr("joint"));
}

TEST(GlbDialect, MorphTargetsThatAreOnMoveTheirPoints) {
  const std::string mesh =
      R"({"weights":[0.5],"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}]})";
  const std::string bytes = triangle_glb(R"({"mesh":0})", mesh, {{"VEC3", {0, 0, 4, 0, 0, 0, 0, 0, 0}}});
  EXPECT_EQ(parse_glb(bytes, "x", "").position[0], glm::dvec3(0, 0, 2));
}

TEST(GlbDialect, StripsAndFansAreTriangles) {
  const auto with_mode = [](const char* mode) {
    return glb(replaced(cube_json(), "\"indices\":2", std::string("\"indices\":2,\"mode\":") + mode), cube_bin());
  };
  // 2 6 7 2 7 3: triangles of the strip without area do not count.
  EXPECT_EQ(parse_glb(with_mode("6"), "x", "lid").triangle.size(), 2u);
  EXPECT_GT(parse_glb(with_mode("5"), "x", "lid").triangle.size(), 1u);
}

TEST(GlbDialect, QuantizedPositionsAreRead) {
  std::string bin;
  for (const std::int16_t value : std::initializer_list<std::int16_t>{0, 0, 0, 0, 32767, 0, 0, 0, 0, -32767, 0, 0})
    bin.append(reinterpret_cast<const char*>(&value), 2);
  const std::string json =
      R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],)"
      R"("extensionsRequired":["KHR_mesh_quantization"],"nodes":[{"mesh":0,"scale":[2,2,2]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":24}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":24,"byteStride":8}],)"
      R"("accessors":[{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"}]})";
  const PlainMesh mesh = parse_glb(glb(json, bin), "x", "");
  EXPECT_EQ(mesh.position[1], glm::dvec3(2, 0, 0));
  EXPECT_EQ(mesh.position[2], glm::dvec3(0, -2, 0));
}

TEST(GlbDialect, NodesComeBeforeMeshDataAndSeveralAreTold) {
  // As after renaming in Blender: the first is called skin and still has the mesh Sphere.
  const std::string nodes = R"({"children":[1,2,3]},{"name":"skin","mesh":0},{"name":"Sphere","mesh":1},{"name":"x"})";
  const std::string meshes = R"({"name":"Sphere","primitives":[{"attributes":{"POSITION":0}}]},)"
                             R"({"name":"Sphere.001","primitives":[{"attributes":{"POSITION":0}}]})";
  const std::string bytes = triangle_glb(nodes, meshes, {});
  EXPECT_EQ(parse_glb(bytes, "x", "Sphere").triangle.size(), 1u);
  EXPECT_EQ(parse_glb(bytes, "x", "Sphere.001").triangle.size(), 1u);
  EXPECT_TRUE(parse_glb(bytes, "x", "Sphere").notes.empty());
}

TEST(GlbDialect, ValuesOfAnotherTypeAreRefusedByTheirName) {
  // The library would take defaults for these.
  const auto message = [](const std::string& node, const std::string& mesh) {
    return message_of(triangle_glb(node, mesh, {}));
  };
  const std::string node = R"({"mesh":0})";
  EXPECT_THAT(message(R"({"mesh":"0"})", plain_mesh),
              HasSubstr("x.glb:nodes[0].mesh: error: it must be a whole number"));
  EXPECT_THAT(message(R"({"mesh":0,"scale":[1,2]})", plain_mesh),
              HasSubstr("nodes[0].scale: error: it must be 3 numbers"));
  EXPECT_THAT(message(R"({"mesh":0,"rotation":[0,0,0,2]})", plain_mesh), HasSubstr("node 0: error: its rotation"));
  EXPECT_THAT(message(R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":[1,1,1]})", plain_mesh),
              HasSubstr("node 0: error: has both a matrix and a scale"));
  EXPECT_THAT(message(node, replaced(plain_mesh, "0", "-1")),
              HasSubstr("attributes: error: it must be an object of whole"));
  EXPECT_THAT(message(R"({"mesh":0,"mesh":0})", plain_mesh),
              HasSubstr("byte 20: error: the key \"mesh\" stands twice"));
  EXPECT_THAT(message(R"({"mesh":0,"children":[0]})", plain_mesh), HasSubstr("node 0: error: is held twice"));
}

TEST(GlbDialect, NodesOfOneNameAreToldAndAllRead) {
  const std::string nodes = R"({"children":[1,2]},{"name":"pea","mesh":0},{"name":"pea","mesh":0})";
  const PlainMesh mesh = parse_glb(triangle_glb(nodes, plain_mesh, {}), "x", "pea");
  EXPECT_EQ(mesh.triangle.size(), 2u);
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_THAT(mesh.notes[0], HasSubstr("2 nodes are called \"pea\""));
}

TEST(GlbDialect, ANodeWithoutAMeshStandsForWhatItHolds) {
  const std::string nodes = R"({"name":"plum","children":[1,2]},{"name":"a","mesh":0},{"name":"b","mesh":0})";
  EXPECT_EQ(parse_glb(triangle_glb(nodes, plain_mesh, {}), "x", "plum").triangle.size(), 2u);
}

}  // namespace
}  // namespace pomona
