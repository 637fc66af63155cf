#include <gmock/gmock.h>
#include <cstdint>
#include <cstring>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/surface/file/obj_file.h"
#include "render/export/obj.h"
#include "render/export/stl.h"
#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

template <typename Value>
Value value_at(const std::string& bytes, std::size_t offset) {
  Value value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(Value));
  return value;
}

/// Six times the volume that an STL's triangles enclose, in its own unit.
double six_volumes(const std::string& stl) {
  double sum = 0;
  for (std::uint32_t t = 0; t < value_at<std::uint32_t>(stl, 80); ++t) {
    glm::dvec3 corner[3];
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = glm::dvec3(value_at<glm::vec3>(stl, 84 + 50 * std::size_t{t} + 12 + 12 * i));
    sum += glm::dot(corner[0], glm::cross(corner[1], corner[2]));
  }
  return sum;
}

TEST(Stl, HoldsTheVolumesInMillimetres) {
  Scene scene = named::mixed();
  double volume = 0;
  std::erase_if(scene.instances,
                [&](const Instance& i) { return !scene.solids[static_cast<std::size_t>(i.solid)].closed; });
  for (const Instance& instance : scene.instances) {
    const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
    for (const glm::uvec3& t : solid.mesh.triangle)
      volume += glm::dot(glm::dvec3(solid.mesh.position[t.x]),
                         glm::cross(glm::dvec3(solid.mesh.position[t.y]), glm::dvec3(solid.mesh.position[t.z]))) /
                6;
  }
  const std::string stl = write_stl(scene);
  EXPECT_GT(volume, 0);
  EXPECT_NEAR(six_volumes(stl) / 6, volume * 1e9, volume * 1e9 * 1e-5);
  EXPECT_EQ(stl.size(), 84 + 50 * std::size_t{value_at<std::uint32_t>(stl, 80)});
  EXPECT_NE(stl.substr(0, 5), "solid") << "readers would take it for ASCII";
}

/// Normals are to the bit those of the rounded corners in the file, not of the places before rounding.
TEST(Stl, HasTheNormalsOfItsCorners) {
  const std::string stl = write_stl(gathered({named::ball("ball", 0.0371f, 12, Color(0.5f))}));
  for (std::uint32_t t = 0; t < value_at<std::uint32_t>(stl, 80); ++t) {
    const std::size_t at = 84 + 50 * std::size_t{t};
    glm::dvec3 corner[3];
    for (std::size_t i = 0; i < 3; ++i) corner[i] = glm::dvec3(value_at<glm::vec3>(stl, at + 12 + 12 * i));
    const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    ASSERT_EQ(value_at<glm::vec3>(stl, at), glm::vec3(normal / glm::length(normal))) << t;
  }
}

TEST(Stl, LeavesOutTrianglesWithoutArea) {
  Solid leaf = named::leaf("leaf", Color(0.5f));
  leaf.mesh.triangle.push_back({0, 0, 1});
  EXPECT_EQ(value_at<std::uint32_t>(write_stl(gathered({leaf})), 80), 1u);
}

TEST(Obj, ReadsBackAsItWas) {
  const Solid box =
      named::box("a box", {-0.01f, 0, 0.02f}, {0.03f, 0.05f, 0.07f}, {0.8f, 0.1f, 0.1f}, {0.9f, 0.8f, 0.4f});
  const std::string text = write_obj(gathered({box}));
  EXPECT_THAT(text, testing::HasSubstr("\no a_box\nv "));
  const PlainMesh read = parse_obj(text, "box.obj", "a_box");
  ASSERT_EQ(read.triangle.size(), box.mesh.triangle.size());
  ASSERT_EQ(read.color.size(), read.position.size());
  double volume = 0;
  for (const glm::uvec3& t : read.triangle)
    volume += glm::dot(read.position[t.x], glm::cross(read.position[t.y], read.position[t.z])) / 6;
  EXPECT_NEAR(volume, 0.04 * 0.05 * 0.05, 1e-9);
  for (std::size_t v = 0; v < read.position.size(); ++v) {
    const auto x = static_cast<float>(read.position[v].x);
    EXPECT_TRUE(x == -0.01f || x == 0.03f) << "the same bits";
    const bool on_top = read.color[v].r > 0.85f;
    EXPECT_TRUE(!on_top || static_cast<float>(read.position[v].y) == 0.05f);
  }
}

/// The error comes before anything is written.
TEST(Stl, RefusesMoreTrianglesThanItCanCount) {
  Scene scene;
  scene.solids = {named::leaf("leaf", Color(0.5f))};
  scene.solids[0].mesh.triangle.resize(65536, {0, 1, 2});
  scene.instances.assign(65536, {0, {}, {}});
  try {
    write_stl(scene);
    ADD_FAILURE() << "nothing was told";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("4294967296"));
  }
}

}  // namespace
}  // namespace pomona
