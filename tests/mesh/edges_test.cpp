#include "generator/mesh/edges.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"
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

TEST(Weld, FindsWhatTryingAllVerticesFinds) {
  const RandomStream random({1, 0}, "places");
  std::vector<glm::vec3> places;
  for (std::uint64_t i = 0; i < 2000; ++i)
    places.emplace_back(random.below(3 * i, 9), -static_cast<float>(random.below(3 * i + 1, 9)),
                        random.below(3 * i + 2, 9));
  places[3] = {0.0f, -0.0f, 0.0f}, places[7] = {-0.0f, 0.0f, -0.0f};
  const std::vector<std::uint32_t> first = weld(places);
  const std::vector<glm::dvec3> wide(places.begin(), places.end());
  EXPECT_EQ(weld(wide), first);
  for (std::size_t v = 0; v < places.size(); ++v)
    EXPECT_EQ(first[v], std::find(places.begin(), places.end(), places[v]) - places.begin());
}

TEST(Edges, AreInTheOrderThatComparingThemGives) {
  // Cases: few corners in many triangles, many corners with gaps in their numbers, and edges of several kinds.
  const RandomStream random({2, 0}, "triangles");
  for (const std::uint64_t vertices : {5u, 40u, 900u, 4000000000u}) {
    std::vector<glm::uvec3> triangles;
    std::vector<std::int32_t> kind;
    for (std::uint64_t i = 0; i < 700; ++i) {
      triangles.emplace_back(random.below(4 * i, vertices), random.below(4 * i + 1, vertices),
                             random.below(4 * i + 2, vertices));
      kind.push_back(static_cast<std::int32_t>(random.below(4 * i + 3, 5)) - 2);
    }
    const std::vector<HalfEdge> sorted = sorted_half_edges(triangles, {.kind = kind, .of_collapsed = true});
    EXPECT_GT(sorted.size(), 1000u);
    const auto order = [](const HalfEdge& h) { return std::tie(h.kind, h.low, h.high, h.triangle, h.side); };
    EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end(),
                               [&](const HalfEdge& a, const HalfEdge& b) { return order(a) < order(b); }));
  }
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
