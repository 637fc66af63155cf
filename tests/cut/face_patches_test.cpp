// Patches of faces made by hand.
#include "generator/cut/section/face_patches.h"

#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// A row of triangles; those before `wall` are separated from the rest.
Face strip(std::uint32_t count, std::uint32_t wall) {
  Face face;
  for (std::uint32_t v = 0; v < count + 2; ++v) {
    face.place.emplace_back(0.5 * v, v % 2, 0);
    face.point.push_back(v);
  }
  for (std::uint32_t t = 0; t < count; ++t) {
    // Edge 1 is shared with the next, edge 2, of every other one edge 0, with the one before.
    face.triangle.push_back(t % 2 == 0 ? glm::uvec3(t, t + 2, t + 1) : glm::uvec3(t, t + 1, t + 2));
    std::array<std::int32_t, 3> neighbor{Face::none, Face::none, Face::none};
    neighbor[1] = t + 1 < count ? static_cast<std::int32_t>(t + 1) : Face::none;
    neighbor[t % 2 == 0 ? 2 : 0] = static_cast<std::int32_t>(t) - 1;
    face.neighbor.push_back(neighbor);
    std::array<std::uint8_t, 3> constrained{0, 0, 0};
    constrained[1] = t + 1 == wall ? 1 : 0;
    constrained[t % 2 == 0 ? 2 : 0] = t == wall ? 1 : 0;
    face.constrained.push_back(constrained);
    face.facet.push_back(0);
  }
  return face;
}

TEST(FacePatches, EveryTriangleIsInOneAndWallsPartThem) {
  for (std::uint32_t wall = 0; wall < 5; ++wall) {
    const FacePatches patches = patches_of(strip(5, wall), {}, {});
    EXPECT_EQ(patches.count(), wall == 0 ? 1u : 2u) << wall;
    for (std::uint32_t t = 0; t < 5; ++t) EXPECT_EQ(patches.patch_of[t], wall > 0 && t >= wall ? 1u : 0u) << wall;
  }
  EXPECT_EQ(patches_of(strip(1, 0), {}, {}).patch_of, std::vector<std::uint32_t>{0});
}

/// A strip with segments from vertex to vertex, each of a triangle of its own; `bodies` says of which body.
std::vector<std::int32_t> open_bodies(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& ways,
                                      const std::vector<std::int32_t>& bodies) {
  Face face = strip(5, 0);
  for (const auto& [from, to] : ways) {
    const auto segment = static_cast<std::uint32_t>(face.segment.size());
    face.segment.push_back({from, to, from, to, segment});
    face.edges.push_back({std::min(from, to), std::max(from, to), segment, from < to});
  }
  face.sort_edges();
  Bodies of;
  of.of_triangle = bodies;
  return patches_of(face, shapes::sphere(1, 2, shapes::skin_paint()), of).open_body;
}

TEST(FacePatches, BodiesAreOpenWhoseBoundaryDoesNotCloseAtEveryVertex) {
  using Numbers = std::vector<std::int32_t>;
  EXPECT_EQ(open_bodies({{0, 1}, {1, 2}, {2, 0}}, {0, 0, 0}), Numbers{});
  EXPECT_EQ(open_bodies({{0, 1}, {1, 2}}, {0, 0}), Numbers{0});
  EXPECT_EQ(open_bodies({{0, 1}, {1, 2}, {0, 2}}, {0, 0, 0}), Numbers{0}) << "no way round";
  EXPECT_EQ(open_bodies({{0, 1}, {1, 2}, {2, 0}}, {0, 1, 0}), (Numbers{0, 1})) << "each by itself";
  EXPECT_EQ(open_bodies({{0, 1}, {1, 2}, {2, 0}, {1, 3}}, {0, 0, 0, 2}), Numbers{2});
  EXPECT_EQ(open_bodies({{0, 1}, {1, 2}}, {Bodies::none, Bodies::none}), Numbers{}) << "inner surfaces end anywhere";
}

}  // namespace
}  // namespace pomona
