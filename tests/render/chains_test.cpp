#include "render/picture/chains.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "render/picture/stroke.h"

namespace pomona {
namespace {

using ::testing::ElementsAre;

std::vector<glm::dvec2> on_circle(int count) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    points.emplace_back(100 + 80 * reproducible::cos(angle), 100 + 80 * reproducible::sin(angle));
  }
  return points;
}

/// Links of a loop, every other one turned round, in an order that jumps about.
std::vector<ChainLink> shuffled_loop(std::uint32_t count) {
  std::vector<ChainLink> links;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = i * 7 % count;
    const std::uint32_t b = (a + 1) % count;
    links.push_back(i % 2 == 0 ? ChainLink{a, b} : ChainLink{b, a});
  }
  return links;
}

TEST(Chains, MakeOneLoopOfShuffledLinks) {
  const std::vector<glm::dvec2> nodes = on_circle(24);
  const std::vector<ChainLink> links = shuffled_loop(24);
  const std::vector<Chain> chains = chained(links, nodes);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_TRUE(chains[0].closed);
  const std::vector<std::uint32_t> walk = nodes_of(chains[0], links);
  ASSERT_EQ(walk.size(), 24u);
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const std::uint32_t step = (walk[(i + 1) % 24] + 24 - walk[i]) % 24;
    EXPECT_TRUE(step == 1 || step == 23) << i;
  }
}

TEST(Chains, GoStraightOverACrossing) {
  // Two lines that cross in node 4.
  const std::vector<glm::dvec2> nodes{{0, 0}, {2, 2}, {0, 2}, {2, 0}, {1, 1}};
  const std::vector<ChainLink> links{{0, 4}, {4, 1}, {2, 4}, {4, 3}};
  const std::vector<Chain> chains = chained(links, nodes);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_THAT(nodes_of(chains[0], links), ElementsAre(0, 4, 1));
  EXPECT_THAT(nodes_of(chains[1], links), ElementsAre(2, 4, 3));
}

TEST(Chains, EndWhereALineTurnsBack) {
  const std::vector<glm::dvec2> nodes{{0, 0}, {10, 0}, {1, 0.1}};
  EXPECT_EQ(chained(std::vector<ChainLink>{{0, 1}, {1, 2}}, nodes).size(), 2u);
}

TEST(Chains, HoldEveryLinkOnce) {
  const std::vector<glm::dvec2> nodes{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  const std::vector<ChainLink> links{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 2}};
  std::vector<std::uint32_t> seen;
  for (const Chain& chain : chained(links, nodes)) seen.insert(seen.end(), chain.links.begin(), chain.links.end());
  std::sort(seen.begin(), seen.end());
  EXPECT_THAT(seen, ElementsAre(0, 1, 2, 3, 4, 5, 6));
}

TEST(Stroke, TapersAtItsEndsAndVariesBetween) {
  PenLine line;
  for (int i = 0; i <= 20; ++i) line.points.emplace_back(20 * i, 5 * (i % 2));
  line.opacity.assign(line.points.size(), 1.0);
  const std::vector<StrokePoint> stroke = drawn(line, {.width = 8, .taper = 50});
  double widest = 0, narrowest = 100;
  for (std::size_t i = stroke.size() / 3; i < 2 * stroke.size() / 3; ++i) {
    widest = std::max(widest, stroke[i].radius);
    narrowest = std::min(narrowest, stroke[i].radius);
  }
  EXPECT_LT(stroke.front().radius, 0.4 * narrowest);
  EXPECT_LT(stroke.back().radius, 0.4 * narrowest);
  EXPECT_GT(widest, 1.1 * narrowest);
  EXPECT_LE(widest, 8);
}

TEST(Stroke, StaysOnItsLine) {
  PenLine line{.points = on_circle(90), .opacity = std::vector<double>(90, 1.0), .closed = true};
  for (const StrokePoint& point : drawn(line, {.width = 3, .sway = 0.5})) {
    EXPECT_NEAR(glm::distance(point.at, glm::dvec2(100)), 80, 1.0);
  }
}

TEST(Ink, IsNoDarkerWhereItIsDrawnTwice) {
  PenLine line{.points = {{5, 10}, {35, 10}}, .opacity = {0.5, 0.5}};
  const std::vector<StrokePoint> stroke = drawn(line, {.width = 6});
  InkLayer once(40, 20), twice(40, 20);
  once.draw(stroke);
  twice.draw(stroke);
  twice.draw(stroke);
  for (int x = 0; x < 40; ++x) EXPECT_EQ(once.at(x, 10), twice.at(x, 10));
  EXPECT_NEAR(once.at(20, 10), 0.5, 1e-6);
  EXPECT_EQ(once.at(20, 1), 0.0);
}

}  // namespace
}  // namespace pomona
