// Crossings of swept grids, of which most pairs of tiles are proved clear without a look at their triangles.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "generator/base/random.h"
#include "generator/surface/crossings.h"
#include "generator/surface/surface_tiles.h"
#include "generator/surface/sweep/sweep.h"
#include "generator/template/unpainted.h"
#include "tests/variation/fruits.h"

namespace pomona {
namespace {

using Pair = std::tuple<std::uint32_t, std::uint32_t, bool>;

std::vector<Pair> crossing_pairs(const DiffusionSurfaces& surfaces) {
  std::vector<Pair> pairs;
  for (const CrossingTriangles& c : crossing_triangles(surfaces)) pairs.emplace_back(c.first, c.second, c.same_piece);
  return pairs;
}

/// The same with triangles dealt out, so that nothing is a grid and nothing that lies together is a tile.
std::vector<Pair> pairs_in_another_order(const DiffusionSurfaces& surfaces) {
  const std::size_t count = surfaces.triangle_count();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const RandomStream stream({3, 1}, "swept_tiles_test");
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(stream.uniform(i) * static_cast<double>(i))]);
  DiffusionSurfaces dealt = surfaces;
  for (std::size_t i = 0; i < count; ++i) {
    dealt.triangle[i] = surfaces.triangle[order[i]];
    dealt.surface[i] = surfaces.surface[order[i]];
  }
  std::vector<Pair> pairs;
  for (const auto& [a, b, same] : crossing_pairs(dealt))
    pairs.emplace_back(std::min(order[a], order[b]), std::max(order[a], order[b]), same);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Layers around the axis with poles, and chambers in folds.
std::vector<DiffusionSurfaces> swept_fruits() {
  std::vector<DiffusionSurfaces> swept;
  for (Template fruit : {fruits::onion(2), fruits::tomato(5), fruits::curly()}) {
    for (const double bend : {0.0, 0.9}) {
      fruit.bend.angle = bend;
      swept.push_back(sweep(unpainted(fruit), {.detail = 0.4}));
    }
  }
  return swept;
}

TEST(SweptTiles, LeaveTheCrossingsAsTheyAreHoweverSurfacesAreTorn) {
  const RandomStream stream({5, 1}, "swept_tiles_test");
  std::size_t most = 0;
  for (const DiffusionSurfaces& smooth : swept_fruits()) {
    const glm::dvec3 size = bounds_of(smooth).size();
    for (const double torn : {0.0, 0.01, 0.03, 0.1, 0.3}) {
      DiffusionSurfaces surfaces = smooth;
      for (std::size_t v = 0; v < surfaces.vertex_count(); ++v)
        for (int k = 0; k < 3; ++k)
          surfaces.position[v][k] +=
              static_cast<float>(torn * size.y * (stream.uniform(3 * v + static_cast<std::size_t>(k)) - 0.5));
      const std::vector<Pair> pairs = crossing_pairs(surfaces);
      EXPECT_EQ(pairs, pairs_in_another_order(surfaces)) << torn;
      most = std::max(most, pairs.size());
    }
  }
  EXPECT_GT(most, 1000u);
}

TEST(SweptTiles, OfSmoothSurfacesAreProvedClearInMostCases) {
  for (const DiffusionSurfaces& surfaces : {sweep(unpainted(fruits::onion(2))), sweep(unpainted(fruits::tomato(5)))}) {
    SurfaceTiles tiles(surfaces, 1e-10);
    ASSERT_GT(tiles.count(), 50u);
    std::uint32_t clear = 0;
    std::size_t triangles = 0;
    for (std::uint32_t tile = 0; tile < tiles.count(); ++tile) {
      clear += tiles.are_clear(tile, tile) ? 1 : 0;
      triangles += tiles.triangles(tile).size();
    }
    EXPECT_GT(clear, 0.5 * tiles.count());
    EXPECT_EQ(triangles, surfaces.triangle_count());
  }
}

TEST(SweptTiles, ThatMeetAreNotProvedClear) {
  // A fold that runs back through its own layer.
  DiffusionSurfaces surfaces = sweep(unpainted(fruits::onion(1)));
  SurfaceTiles before(surfaces, 1e-10);
  const std::uint32_t tile = before.count() / 2;
  ASSERT_TRUE(before.are_clear(tile, tile));
  const glm::uvec3 first = surfaces.triangle[before.triangles(tile).front()],
                   last = surfaces.triangle[before.triangles(tile).back()];
  std::swap(surfaces.position[first.x], surfaces.position[last.y]);
  ASSERT_FALSE(crossing_triangles(surfaces).empty());
  EXPECT_FALSE(SurfaceTiles(surfaces, 1e-10).are_clear(tile, tile));
}

}  // namespace
}  // namespace pomona
