#include "generator/mesh/edges.h"

#include <gtest/gtest.h>

#include "generator/mesh/weld.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

std::vector<glm::uvec3> welded(const DiffusionSurfaces& surfaces) {
  return welded_triangles(weld(surfaces.position), surfaces.triangle);
}

std::size_t edge_count(const std::vector<glm::uvec3>& triangles) {
  std::size_t count = 0;
  for_each_edge(sorted_half_edges(triangles), [&](std::span<const HalfEdge>) { ++count; });
  return count;
}

std::size_t vertex_count(const DiffusionSurfaces& surfaces) {
  const std::vector<std::uint32_t> first = weld(surfaces.position);
  std::size_t count = 0;
  for (std::size_t v = 0; v < first.size(); ++v) count += first[v] == v ? 1 : 0;
  return count;
}

TEST(Weld, LetsTheFirstVertexStandForAllAtOnePlace) {
  const std::vector<glm::vec3> positions{{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-0.0f, 0, -0.0f}, {1, 0, 1e-30f}};
  EXPECT_EQ(weld(positions), (std::vector<std::uint32_t>{0, 1, 0, 1, 4}));
}

TEST(Edges, AreAsManyAsEulersFormulaSays) {
  const DiffusionSurfaces ball = shapes::sphere(1, 5), box = shapes::box({0, 0, 0}, {1, 2, 3}, 3),
                          ring = shapes::torus(3, 1, 12, 9);
  EXPECT_EQ(vertex_count(ball) + ball.triangle_count(), edge_count(welded(ball)) + 2);
  EXPECT_EQ(vertex_count(box) + box.triangle_count(), edge_count(welded(box)) + 2);
  EXPECT_EQ(vertex_count(ring) + ring.triangle_count(), edge_count(welded(ring))) << "a torus has a hole";
}

TEST(Edges, OfSolidsAreRunOnceEachWay) {
  const std::vector<glm::uvec3> triangles = welded(shapes::torus(3, 1, 12, 9));
  for_each_edge(sorted_half_edges(triangles), [](std::span<const HalfEdge> edge) {
    ASSERT_EQ(edge.size(), 2u);
    EXPECT_NE(edge[0].forward, edge[1].forward);
    EXPECT_LT(edge[0].triangle, edge[1].triangle);
    EXPECT_EQ(balance(edge), 0);
  });
}

TEST(Edges, TellWhatIsClosed) {
  std::vector<glm::uvec3> triangles = welded(shapes::sphere(1, 4));
  EXPECT_TRUE(is_closed(triangles));
  std::swap(triangles[7].x, triangles[7].y);
  EXPECT_FALSE(is_closed(triangles)) << "one triangle turned over";
  std::swap(triangles[7].x, triangles[7].y);
  triangles.pop_back();
  EXPECT_FALSE(is_closed(triangles)) << "one triangle missing";
  EXPECT_FALSE(is_closed(welded(shapes::open_sheet(1, 0, 3))));
}

TEST(Edges, MayHaveAnyNumberOfTriangles) {
  const std::vector<glm::uvec3> fan{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const std::vector<HalfEdge> sorted = sorted_half_edges(fan);
  const std::span<const HalfEdge> spine = edge_at(sorted, 0);
  ASSERT_EQ(spine.size(), 3u);
  EXPECT_EQ(balance(spine), 1);
  EXPECT_EQ(edge_count(fan), 7u);
}

TEST(Edges, AreNotSharedByTrianglesOfDifferentKinds) {
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const std::vector<std::int32_t> kind{5, -1, 5};
  std::vector<std::size_t> runs;
  for_each_edge(sorted_half_edges(triangles, {.kind = kind}), [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& h : edge) EXPECT_EQ(h.kind, kind[h.triangle]);
    if (edge.front().low == 0 && edge.front().high == 1) runs.push_back(edge.size());
  });
  EXPECT_EQ(runs, (std::vector<std::size_t>{1, 2}));
}

TEST(Edges, OfCollapsedTrianglesAreLeftOutUnlessAskedFor) {
  const std::vector<glm::uvec3> triangles{{0, 1, 0}, {2, 2, 2}};
  EXPECT_TRUE(sorted_half_edges(triangles).empty());
  const std::vector<HalfEdge> sides = sorted_half_edges(triangles, {.of_collapsed = true});
  ASSERT_EQ(sides.size(), 2u) << "there and back; a side from 0 to 0 is none";
  EXPECT_EQ(balance(sides), 0);
}

TEST(Edges, LeadBackToTheVerticesBeforeWelding) {
  const DiffusionSurfaces box = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  const std::vector<std::uint32_t> first = weld(box.position);
  for (const HalfEdge& h : sorted_half_edges(welded(box))) {
    const glm::uvec2 ends = ends_in(box.triangle, h);
    EXPECT_EQ(first[ends.x], h.low);
    EXPECT_EQ(first[ends.y], h.high);
    EXPECT_EQ(box.triangle[h.triangle][h.side], h.forward ? ends.x : ends.y);
  }
}

}  // namespace
}  // namespace pomona
