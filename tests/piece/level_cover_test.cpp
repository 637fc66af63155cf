// The proof that a level is near its solid and the solid near its level. It must notice a peak between corners, a
// surface that faces the other way, a hole, and a place beyond a border.
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/vec3.hpp>

#include "generator/piece/lod/collapse.h"
#include "generator/piece/lod/level_cover.h"
#include "generator/piece/lod/level_mesh.h"
#include "generator/piece/lod/patch_cover.h"
#include "generator/piece/lod/piece_cover.h"
#include "generator/piece/lod/vertex_fans.h"

namespace pomona {
namespace {

constexpr double bound = 0.1;
constexpr std::uint32_t side = 5;  // vertices along a side of the sheet

std::uint32_t at(std::uint32_t x, std::uint32_t y) { return y * side + x; }

/// Four by four squares of two triangles each, in one plane, facing up.
Solid sheet() {
  Solid solid;
  SolidMesh& mesh = solid.mesh;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) mesh.position.emplace_back(x, y, 0);
  for (std::uint32_t y = 0; y + 1 < side; ++y) {
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      mesh.triangle.emplace_back(at(x, y), at(x + 1, y), at(x + 1, y + 1));
      mesh.triangle.emplace_back(at(x, y), at(x + 1, y + 1), at(x, y + 1));
    }
  }
  mesh.normal.assign(mesh.position.size(), {0, 0, 1});
  mesh.color.assign(mesh.position.size(), Color(0.5f));
  mesh.part.assign(mesh.position.size(), 0);
  mesh.cut_face.assign(mesh.triangle.size(), -1);
  mesh.surface.assign(mesh.triangle.size(), 0);
  return solid;
}

/// The fan at a vertex.
std::uint32_t fan_at(const VertexFans& fans, std::uint32_t vertex) {
  for (std::uint32_t f = 0; f < fans.vertex.size(); ++f)
    if (fans.vertex[f] == vertex) return f;
  return none;
}

/// Whether a triangle that starts at the vertex (0, 0) is near the solid.
bool covers(const Solid& solid, const TriangleCorners& corner) {
  const VertexFans fans = vertex_fans(solid);
  const LevelSource source = level_source(fans, solid.mesh);
  const LevelMesh level = level_mesh(source);
  PatchCover cover(source);
  const std::array<std::uint32_t, 3> no_chain{none, none, none};
  return cover.covers({.corner = corner, .patch = 0, .fan = fan_at(fans, 0), .chain = no_chain, .bound = bound},
                      level.chains);
}

TriangleCorners whole_at(double height) { return {{{0, 0, height}, {4, 0, height}, {4, 4, height}}}; }

TEST(PatchCover, CoversWhatLiesOnTheSheetOrWithinTheBound) {
  EXPECT_TRUE(covers(sheet(), whole_at(0)));
  EXPECT_TRUE(covers(sheet(), whole_at(0.99 * bound)));
  EXPECT_TRUE(covers(sheet(), whole_at(-0.99 * bound)));
  EXPECT_FALSE(covers(sheet(), whole_at(1.01 * bound)));
  EXPECT_FALSE(covers(sheet(), whole_at(-1.01 * bound)));
}

TEST(PatchCover, SeesAPeakBetweenTheCorners) {
  Solid solid = sheet();
  solid.mesh.position[at(3, 1)].z = 0.099f;
  EXPECT_TRUE(covers(solid, whole_at(0)));
  solid.mesh.position[at(3, 1)].z = 0.101f;
  EXPECT_FALSE(covers(solid, whole_at(0)));
}

TEST(PatchCover, LooksOnlyAtWhatLiesWithin) {
  Solid solid = sheet();
  solid.mesh.position[at(1, 3)].z = 5;
  EXPECT_TRUE(covers(solid, whole_at(0))) << "a peak beyond its side";
}

TEST(PatchCover, IsNotNearTheOtherSide) { EXPECT_FALSE(covers(sheet(), {{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}}})); }

TEST(PatchCover, DoesNotLeapOverAHole) {
  Solid solid = sheet();
  const std::size_t gone = 2 * 2 + 1;  // in the first row, inside
  ASSERT_TRUE(covers(solid, whole_at(0)));
  solid.mesh.triangle.erase(solid.mesh.triangle.begin() + gone - 1);
  solid.mesh.cut_face.pop_back(), solid.mesh.surface.pop_back();
  EXPECT_FALSE(covers(solid, whole_at(0)));
}

TEST(PatchCover, DoesNotReachBeyondTheRim) { EXPECT_FALSE(covers(sheet(), {{{0, 0, 0}, {4.5, 0, 0}, {4, 4, 0}}})); }

TEST(PatchCover, MayReachBeyondTheRimWhereASideStandsForIt) {
  Solid solid = sheet();
  solid.mesh.position[at(2, 0)].y = 0.05f;  // a dent in the rim
  const VertexFans fans = vertex_fans(solid);
  const LevelSource source = level_source(fans, solid.mesh);
  LevelMesh level = level_mesh(source);
  const std::optional<Collapse> collapse = collapse_of(
      source, level, fan_at(fans, at(2, 0)), ring_of_collapse(level, fan_at(fans, at(2, 0)), fan_at(fans, at(1, 0))));
  ASSERT_TRUE(collapse && collapse->border);
  const TriangleCorners corner{{{1, 0, 0}, {3, 0, 0}, {3, 1, 0}}};
  PatchCover cover(source);
  CoverQuery query{
      .corner = corner, .patch = 0, .fan = fan_at(fans, at(1, 0)), .chain = {none, none, none}, .bound = bound};
  EXPECT_FALSE(cover.covers(query, level.chains));
  query.chain[0] = collapse->border->kept;
  merge_chains(level.chains, *collapse);
  EXPECT_TRUE(cover.covers(query, level.chains));
}

/// Number of uncovered faces of a sheet with a peak, after the peak has been removed.
std::size_t uncovered_with_peak(float height) {
  Solid solid = sheet();
  solid.mesh.position[at(2, 2)].z = height;
  const VertexFans fans = vertex_fans(solid);
  const LevelSource source = level_source(fans, solid.mesh);
  LevelMesh level = level_mesh(source);
  const std::optional<Collapse> collapse = collapse_of(
      source, level, fan_at(fans, at(2, 2)), ring_of_collapse(level, fan_at(fans, at(2, 2)), fan_at(fans, at(2, 1))));
  EXPECT_TRUE(collapse);
  if (collapse) apply(level, *collapse);
  std::vector<std::uint32_t> near(source.patch.size());
  std::iota(near.begin(), near.end(), 0u);
  const std::vector<std::uint8_t> changed(source.patch.size(), 1);
  return uncovered_faces(source, level, bound, changed, near).size();
}

TEST(UncoveredFaces, AreThoseAtAPeakThatIsGone) {
  EXPECT_EQ(uncovered_with_peak(0.099f), 0u);
  EXPECT_EQ(uncovered_with_peak(0.101f), 6u);
}

TEST(IsCovered, PutsPiecesTogether) {
  const TriangleCorners left{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, right{{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  const TriangleCorners across{{{0.1, 0.1, 0.05}, {0.9, 0.9, 0.05}, {0.1, 0.9, 0.05}}};
  const std::vector<CoveringTriangle> both{covering_triangle(left, bound), covering_triangle(right, bound)};
  EXPECT_TRUE(is_covered(across, both, bound, 6));
  EXPECT_FALSE(is_covered(across, std::span(both).first(1), bound, 6));
  EXPECT_FALSE(is_covered(across, both, 0.049, 6));
}

TEST(CollapseOf, LeavesAMeshBehind) {
  const Solid solid = sheet();
  const VertexFans fans = vertex_fans(solid);
  const LevelSource source = level_source(fans, solid.mesh);
  LevelMesh level = level_mesh(source);
  const std::optional<Collapse> collapse = collapse_of(
      source, level, fan_at(fans, at(2, 2)), ring_of_collapse(level, fan_at(fans, at(2, 2)), fan_at(fans, at(3, 2))));
  ASSERT_TRUE(collapse);
  apply(level, *collapse);
  EXPECT_EQ(level.faces, solid.mesh.triangle.size() - 2);
  EXPECT_FALSE(level.mesh.has(collapse->fan));
  for (std::uint32_t h = 0; h < level.mesh.twin.size(); ++h) {
    const std::uint32_t twin = level.mesh.twin[h];
    if (level.mesh.is_there[h / 3] == 0 || twin == none) continue;
    EXPECT_EQ(level.mesh.twin[twin], h);
    EXPECT_EQ(level.mesh.from(twin), level.mesh.to(h));
    EXPECT_EQ(level.mesh.to(twin), level.mesh.from(h));
  }
}

TEST(MergeChains, CanBeTakenBack) {
  const Solid solid = sheet();
  const VertexFans fans = vertex_fans(solid);
  const LevelSource source = level_source(fans, solid.mesh);
  LevelMesh level = level_mesh(source);
  const std::optional<Collapse> first = collapse_of(
      source, level, fan_at(fans, at(2, 0)), ring_of_collapse(level, fan_at(fans, at(2, 0)), fan_at(fans, at(1, 0))));
  ASSERT_TRUE(first);
  merge_chains(level.chains, *first);
  apply(level, *first);
  const std::optional<Collapse> second = collapse_of(
      source, level, fan_at(fans, at(1, 0)), ring_of_collapse(level, fan_at(fans, at(1, 0)), fan_at(fans, at(3, 0))));
  ASSERT_TRUE(second && second->border);
  const BorderChains before = level.chains;
  const std::uint32_t last = merge_chains(level.chains, *second);
  EXPECT_EQ(level.chains.of_fan[fan_at(fans, at(2, 0))], second->border->kept);
  EXPECT_EQ(level.chains.of_fan[fan_at(fans, at(1, 0))], second->border->kept);
  part_chains(level.chains, *second, last);
  EXPECT_EQ(level.chains.of_fan, before.of_fan);
  EXPECT_EQ(level.chains.first, before.first);
  EXPECT_EQ(level.chains.last, before.last);
}

}  // namespace
}  // namespace pomona
