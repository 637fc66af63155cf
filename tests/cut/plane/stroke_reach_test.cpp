// What is near a facet is found without asking everything: beside what asking everything finds.
#include "generator/cut/plane/stroke_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/cut/plane/flat_grid.h"

namespace pomona {
namespace {

constexpr double margin = 0.05;

struct FlatBox {
  glm::dvec2 low, high;
};

/// Whether the stretch, sampled finely, comes within the margin of the box.
bool comes_near(const FlatBox& box, const FlatStretch& stretch) {
  for (int i = 0; i <= 1000; ++i) {
    const glm::dvec2 p = glm::mix(stretch.from, stretch.to, i / 1000.0);
    const glm::dvec2 away = glm::max(glm::max(box.low - p, p - box.high), glm::dvec2(0));
    if (std::max(away.x, away.y) <= margin) return true;
  }
  return false;
}

TEST(FlatGrid, FindsAllThatIsNearAStretch) {
  const RandomStream random({}, "tests/flat grid");
  std::uint64_t draw = 0;
  const auto any = [&] {
    draw += 2;
    return glm::dvec2(random.uniform(draw), random.uniform(draw + 1));
  };
  const auto place = [&] { return any() * 12.0 - 1.0; };
  FlatGrid grid({0, 0}, {10, 10}, 100);
  std::vector<FlatBox> boxes;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const glm::dvec2 low = place();
    boxes.push_back({low, low + 0.3 * any()});
    grid.add(i, boxes.back().low, boxes.back().high);
  }
  std::size_t found_in_all = 0;
  for (int n = 0; n < 40; ++n) {
    FlatStretch stretch{place(), place()};
    if (n % 4 == 0) stretch.to.x = stretch.from.x;
    if (n % 4 == 1) stretch.to.y = stretch.from.y;
    const std::vector<std::uint32_t> found = grid.near(stretch.from, stretch.to, margin);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const bool is_found = std::binary_search(found.begin(), found.end(), i);
      EXPECT_TRUE(is_found || !comes_near(boxes[i], stretch));
    }
    found_in_all += found.size();
  }
  EXPECT_LT(found_in_all, 40u * 100) << "a third of all";
}

TEST(StrokeReach, StretchesGoOnAsFarAsAsked) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const Stroke stroke({{0, 0}, {1, 0}, {1, 2}, {3, 2}});
  const FlatStretch middle = stretch_of(stroke.facet(1), 0.5, 10), first = stretch_of(stroke.facet(0), 0.5, 10),
                    line = stretch_of(stroke.facet(1), endless, 10);
  EXPECT_EQ(middle.from, glm::dvec2(1, -0.5));
  EXPECT_EQ(middle.to, glm::dvec2(1, 2.5));
  EXPECT_EQ(first.from, glm::dvec2(-10, 0));
  EXPECT_EQ(first.to, glm::dvec2(1.5, 0));
  EXPECT_EQ(line.from, glm::dvec2(1, -10));
  EXPECT_EQ(line.to, glm::dvec2(1, 10));
}

/// A square of 10 x 10 cells of two triangles.
SplitMesh square() {
  SplitMesh mesh{CutPlanes{}};
  constexpr std::uint32_t row = 11;
  for (std::uint32_t y = 0; y < row; ++y)
    for (std::uint32_t x = 0; x < row; ++x) mesh.add_vertex(mesh.add_point({x, y, 0}, 0), Color(0), Color(0), {});
  for (std::uint32_t y = 0; y + 1 < row; ++y) {
    for (std::uint32_t x = 0; x + 1 < row; ++x) {
      const std::uint32_t v = y * row + x;
      mesh.triangle.emplace_back().vertex = {v, v + 1, v + row + 1};
      mesh.triangle.emplace_back().vertex = {v, v + row + 1, v + row};
    }
  }
  return mesh;
}

TEST(StrokeReach, HasPartsWithTheirTriangleAndItsNeighbours) {
  SplitMesh mesh = square();
  StrokeReach reach(mesh, {0, 0}, {10, 10});
  const auto part = static_cast<std::uint32_t>(mesh.triangle.size());
  mesh.triangle.push_back(mesh.triangle[0]);
  reach.add_part_of(0);
  mesh.triangle.push_back(mesh.triangle[0]);
  reach.add_part_of(part);

  const std::vector<std::uint32_t> near = reach.near({{0.4, 0.2}, {0.6, 0.2}}, margin);
  for (const std::uint32_t t : {0u, part, part + 1}) EXPECT_TRUE(std::binary_search(near.begin(), near.end(), t));

  // All that share a corner with one triangle do so with its parts.
  const std::vector<std::uint32_t> around = reach.neighbours({part + 1});
  std::vector<std::uint32_t> expected;
  for (std::uint32_t t = 0; t < part; ++t) {
    const auto& v = mesh.triangle[t].vertex;
    const auto& own = mesh.triangle[0].vertex;
    if (std::find_first_of(v.begin(), v.end(), own.begin(), own.end()) != v.end()) expected.push_back(t);
  }
  expected.insert(expected.end(), {part, part + 1});
  EXPECT_EQ(around, expected);
}

}  // namespace
}  // namespace pomona
