#include "render/export/ply.h"

#include <gmock/gmock.h>
#include <cstring>

#include <glm/geometric.hpp>

#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

using testing::HasSubstr;

struct Ply {
  std::string header;
  std::string body;
};

Ply split(const std::string& bytes) {
  const std::string end = "end_header\n";
  const std::size_t at = bytes.find(end) + end.size();
  return {bytes.substr(0, at), bytes.substr(at)};
}

template <typename Value>
Value value_at(const std::string& bytes, std::size_t offset) {
  Value value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(Value));
  return value;
}

// What docs/reference/formats.md promises: the sizes of a vertex and a face.
constexpr std::size_t vertex_bytes = 6 * 4 + 3 + 4, face_bytes = 1 + 3 * 4 + 4 + 4;

TEST(SolidsPly, HoldsEveryInstanceWhereItLies) {
  const Scene scene = named::mixed();
  const Ply ply = split(write_solids(scene));
  EXPECT_THAT(ply.header, HasSubstr("comment piece 1 box there\n"));
  EXPECT_THAT(ply.header, HasSubstr("comment part 1 flesh\n"));

  // Two boxes, a leaf, a ball of 8 n^2 triangles.
  const std::size_t vertices = 24 + 24 + 3 + (4 * 16 + 2), faces = 12 + 12 + 1 + 8 * 16;
  EXPECT_THAT(ply.header, HasSubstr("element vertex " + std::to_string(vertices) + "\n"));
  EXPECT_THAT(ply.header, HasSubstr("element face " + std::to_string(faces) + "\n"));
  ASSERT_EQ(ply.body.size(), vertices * vertex_bytes + faces * face_bytes);

  // The second box is turned and moved; the first is not.
  const auto p = value_at<glm::vec3>(ply.body, 24 * vertex_bytes), q = value_at<glm::vec3>(ply.body, 0);
  const Pose& pose = scene.instances[1].pose;
  EXPECT_LT(glm::length(glm::dvec3(p) - (pose.rotation * glm::dvec3(q) + pose.translation)), 1e-7);
}

TEST(SolidsPly, FacesSayTheirPieceAndCut) {
  const Ply ply = split(write_solids(named::mixed()));
  const std::size_t first_face = (24 + 24 + 3 + 66) * vertex_bytes;
  int cut_faces = 0;
  for (std::size_t f = 0; f < 24; ++f) {
    const std::size_t at = first_face + f * face_bytes;
    EXPECT_EQ(value_at<std::uint8_t>(ply.body, at), 3);
    EXPECT_EQ(value_at<std::int32_t>(ply.body, at + 13), f < 12 ? 0 : 1);
    const auto corner = value_at<std::uint32_t>(ply.body, at + 1);
    EXPECT_EQ(corner / 24, f / 12) << "a face uses vertices of its own piece";
    if (value_at<std::int32_t>(ply.body, at + 17) == 0) ++cut_faces;
  }
  EXPECT_EQ(cut_faces, 4) << "two triangles on top of each box";
}

TEST(SolidsPly, NormalsTurnWithTheirPiece) {
  const Scene scene = named::mixed();
  const Ply ply = split(write_solids(scene));
  for (std::size_t v = 0; v < 24; ++v) {
    const auto here = value_at<glm::vec3>(ply.body, v * vertex_bytes + 12);
    const auto there = value_at<glm::vec3>(ply.body, (24 + v) * vertex_bytes + 12);
    EXPECT_LT(glm::length(glm::dvec3(there) - scene.instances[1].pose.rotation * glm::dvec3(here)), 1e-6) << v;
  }
}

TEST(SolidsPly, VerticesOfNoPartSayMinusOne) {
  Scene scene = named::mixed();
  Solid& box = scene.solids[0];
  box.mesh.part[0] = static_cast<std::int32_t>(box.look->part_names.size());
  const Ply ply = split(write_solids(scene));
  EXPECT_EQ(value_at<std::int32_t>(ply.body, 24 + 3), -1);
  EXPECT_EQ(value_at<std::int32_t>(ply.body, vertex_bytes + 24 + 3), 0);
}

}  // namespace
}  // namespace pomona
