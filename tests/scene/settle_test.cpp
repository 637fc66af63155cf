#include "generator/scene/settle/settle.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

std::vector<SettleItem> repeated(int solids, int each) {
  std::vector<SettleItem> items;
  for (int i = 0; i < solids * each; ++i) items.push_back({.solid = i % solids, .name = "piece-" + std::to_string(i)});
  return items;
}

void expect_fit(const Settled& settled, const SettleOptions& options = {}) {
  for (const Fit& fit : settled.fits) {
    EXPECT_LE(fit.gap, options.max_gap);
    EXPECT_LE(fit.penetration, options.max_penetration);
  }
}

bool same(const Pose& a, const Pose& b) { return a.rotation == b.rotation && a.translation == b.translation; }

TEST(Settle, BallsComeToRestInABowl) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  const Settled settled = settle(solids, repeated(1, 12), &bowl);
  ASSERT_EQ(settled.poses.size(), 12u);
  EXPECT_EQ(settled.attempts, 1);
  expect_fit(settled);
}

TEST(Settle, ABallOnTheGroundLiesOnIt) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const Settled settled = settle(solids, repeated(1, 1), nullptr);
  EXPECT_NEAR(settled.poses[0].translation.y, 0.02, 0.0008);
}

TEST(Settle, WithoutABowlPiecesFallWhereTheyAreLetFall) {
  const std::vector<Solid> solids{heap_shapes::wedge(0.02, 60)};
  const auto furthest = [&](double spread) {
    double max = 0;
    for (const Pose& pose : settle(solids, repeated(1, 8), nullptr, {.spread = spread}).poses) {
      max = std::max(max, std::hypot(pose.translation.x, pose.translation.z));
    }
    return max;
  };
  EXPECT_LT(furthest(0.04), 0.08);
  EXPECT_GT(furthest(0.4), 0.1);
}

TEST(Settle, ConcaveRingsAndWedgesFit) {
  const std::vector<Solid> solids{heap_shapes::ring(0.035, 0.029, 0.006), heap_shapes::wedge(0.035, 60)};
  const Solid bowl = heap_shapes::bowl(0.13, 0.07);
  const Settled settled = settle(solids, repeated(2, 6), &bowl);
  expect_fit(settled);
}

/// Then a file with six digits after the point holds them exactly.
TEST(Settle, PosesAreWholeMillionths) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  for (const Pose& pose : settle(solids, repeated(1, 3), &bowl).poses) {
    const auto is_whole = [](double value) { return value == std::round(value * 1e6) / 1e6; };
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(is_whole(pose.translation[k])) << pose.translation[k];
    for (int k = 0; k < 4; ++k) EXPECT_TRUE(is_whole(pose.rotation[k])) << pose.rotation[k];
  }
}

TEST(Settle, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Solid> solids{heap_shapes::ring(0.03, 0.02, 0.008), heap_shapes::wedge(0.03, 90)};
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  SettleOptions one, two;
  one.threads = {1};
  two.threads = {2};
  const Settled a = settle(solids, repeated(2, 3), &bowl, one), b = settle(solids, repeated(2, 3), &bowl, two);
  for (std::size_t i = 0; i < a.poses.size(); ++i) EXPECT_TRUE(same(a.poses[i], b.poses[i])) << i;

  two.seed = 7;
  const Settled other = settle(solids, repeated(2, 3), &bowl, two);
  EXPECT_FALSE(same(a.poses[0], other.poses[0]));
}

TEST(Settle, ASecondHeapAtTheSameTimeChangesNothing) {
  const std::vector<Solid> solids{heap_shapes::ring(0.03, 0.02, 0.008), heap_shapes::wedge(0.03, 90)};
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  const Settled alone = settle(solids, repeated(2, 3), &bowl);
  std::vector<Settled> heaps(2);
  parallel_for(heaps.size(), {2}, [&](std::size_t i) { heaps[i] = settle(solids, repeated(2, 3), &bowl); });
  for (const Settled& heap : heaps)
    for (std::size_t i = 0; i < alone.poses.size(); ++i) EXPECT_TRUE(same(heap.poses[i], alone.poses[i])) << i;
}

/// Three or more waves; the lower ones are frozen when the last ones fall.
TEST(Settle, ManyLayersFit) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02), heap_shapes::wedge(0.025, 120)};
  const Solid bowl = heap_shapes::bowl(0.13, 0.1);
  const Settled settled = settle(solids, repeated(2, 40), &bowl);
  expect_fit(settled);
  const auto outside = [&](const Pose& pose) {
    return std::hypot(pose.translation.x, pose.translation.z) > 0.13 || pose.translation.y < 0;
  };
  EXPECT_EQ(std::count_if(settled.poses.begin(), settled.poses.end(), outside), 0);
}

TEST(Settle, TellsHowFarItIs) {
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const Solid bowl = heap_shapes::bowl(0.12, 0.06);
  std::map<std::string, std::vector<std::size_t>> told;
  SettleOptions options;
  options.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 12u);
    told[stage].push_back(done);
  };
  settle(solids, repeated(1, 12), &bowl, options);
  for (const char* stage : {"settle", "measure"}) {
    ASSERT_FALSE(told[stage].empty()) << stage;
    EXPECT_TRUE(std::is_sorted(told[stage].begin(), told[stage].end())) << stage;
    EXPECT_EQ(told[stage].back(), 12u) << stage;
  }
}

TEST(Settle, PiecesWithoutRoomAreNamed) {
  // Sixty balls of 2 cm radius in a bowl that holds a dozen.
  const std::vector<Solid> solids{heap_shapes::ball(0.02)};
  const Solid bowl = heap_shapes::bowl(0.07, 0.03);
  try {
    settle(solids, repeated(1, 60), &bowl, {.attempts = 2});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::some_items_failed);
    EXPECT_THAT(error.what(),
                testing::ContainsRegex("piece \"piece-[0-9]+\" (finds no room in|lies outside) the bowl"));
  }
}

/// A piece that fits nowhere is dropped again in each attempt, so more attempts take longer.
TEST(Settle, TriesAsOftenAsItMay) {
  const std::vector<Solid> solids{heap_shapes::ball(0.1)};
  const Solid bowl = heap_shapes::bowl(0.06, 0.03);
  const auto told = [&](int attempts) {
    SettleOptions options{.attempts = attempts};
    int count = 0;
    options.progress = [&](const std::string& stage, std::size_t, std::size_t) { count += stage == "settle" ? 1 : 0; };
    EXPECT_THROW(settle(solids, repeated(1, 1), &bowl, options), Error);
    return count;
  };
  const int one = told(1), two = told(2), three = told(3);
  EXPECT_GT(two, one);
  EXPECT_GT(three, two);
}

TEST(Settle, SaysWhichPieceDoesNotFit) {
  // A ball wider than the bowl cannot lie inside it.
  const std::vector<Solid> solids{heap_shapes::ball(0.1)};
  const Solid bowl = heap_shapes::bowl(0.06, 0.03);
  try {
    settle(solids, repeated(1, 1), &bowl, {.attempts = 1});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::some_items_failed);
    EXPECT_THAT(error.what(), testing::HasSubstr("piece \"piece-0\" lies outside the bowl"));
  }
}

}  // namespace
}  // namespace pomona
