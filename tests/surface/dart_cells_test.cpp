// Balls in cells: every ball that may meet another is visited.
#include "generator/surface/sweep/dart_cells.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"

namespace pomona {
namespace {

struct Ball {
  glm::dvec3 center;
  double diameter;
};

/// Balls around the origin, some many times as wide as others.
std::vector<Ball> random_balls(std::size_t count, std::uint64_t seed) {
  const RandomStream random({seed, 0}, "balls");
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 center(random.uniform(8 * i), random.uniform(8 * i + 1), random.uniform(8 * i + 2));
    balls.push_back({0.05 * (2.0 * center - 1.0), 0.002 * std::pow(2, 5 * random.uniform(8 * i + 3) - 1)});
  }
  return balls;
}

bool meet(const Ball& a, const Ball& b) { return glm::distance(a.center, b.center) < 0.5 * (a.diameter + b.diameter); }

TEST(DartCells, AskAboutEveryBallThatMeetsAndAboutNoneTwice) {
  const std::vector<Ball> balls = random_balls(600, 1);
  DartCells cells(0.002);
  for (std::size_t i = 0; i < balls.size(); ++i) cells.add(balls[i].center, balls[i].diameter, i);
  std::size_t intersections = 0;
  for (const Ball& ball : random_balls(200, 2)) {
    std::multiset<std::size_t> asked;
    EXPECT_FALSE(cells.any_meets(ball.center, ball.diameter, [&](std::size_t i) { return asked.insert(i), false; }));
    for (std::size_t i = 0; i < balls.size(); ++i) {
      EXPECT_LE(asked.count(i), 1u);
      if (!meet(ball, balls[i])) continue;
      EXPECT_EQ(asked.count(i), 1u);
      ++intersections;
    }
  }
  EXPECT_GT(intersections, 100u);
}

TEST(DartCells, AnswerAsTryingAllBallsDoes) {
  const std::vector<Ball> balls = random_balls(150, 3);
  DartCells cells(0.002);
  for (std::size_t i = 0; i < balls.size(); ++i) cells.add(balls[i].center, balls[i].diameter, i);
  for (const Ball& ball : random_balls(300, 4)) {
    bool any = false;
    for (const Ball& other : balls) any = any || meet(ball, other);
    EXPECT_EQ(cells.any_meets(ball.center, ball.diameter, [&](std::size_t i) { return meet(ball, balls[i]); }), any);
  }
}

TEST(DartCells, AreEmptyOnceCleared) {
  DartCells cells(1);
  cells.add({0, 0, 0}, 1, 0);
  EXPECT_TRUE(cells.any_meets({0, 0, 0}, 1, [](std::size_t) { return true; }));
  cells.clear();
  EXPECT_FALSE(cells.any_meets({0, 0, 0}, 1, [](std::size_t) { return true; }));
}

}  // namespace
}  // namespace pomona
