#include "generator/diffusion/walk/frame_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/mesh/triangle_distance.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// Triangles of many shapes, next to each other and in each other.
DiffusionSurfaces tangle() {
  const RandomStream random({}, "tests/tangle of triangles");
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> triangle;
  for (std::uint32_t n = 0; n < 180; n += 3)
    position.emplace_back(random.uniform(n), random.uniform(n + 1), random.uniform(n + 2));
  for (std::uint32_t v = 0; v < position.size(); v += 3) triangle.emplace_back(v, v + 1, v + 2);
  return shapes::painted(position, triangle, {});
}

std::vector<glm::vec3> places() {
  const RandomStream random({}, "tests/places around a tangle");
  std::vector<glm::vec3> all;
  for (std::uint64_t n = 0; n < 900; n += 3)
    all.emplace_back(2 * random.uniform(n) - 1, 2 * random.uniform(n + 1) - 1, 2 * random.uniform(n + 2) - 1);
  return all;
}

double true_distance(const DiffusionSurfaces& surfaces, const TriangleFrames& frames, std::uint32_t triangle,
                     const glm::vec3& place) {
  auto [a, b, c] = corners(surfaces, triangle);
  a = frames.normalized(a), b = frames.normalized(b), c = frames.normalized(c);
  const glm::dvec3 p(place), w = nearest_weights(p, a, b, c);
  return glm::length(p - (w.x * a + w.y * b + w.z * c));
}

TEST(FrameDistance, IsThatToEachTriangle) {
  const DiffusionSurfaces surfaces = tangle();
  const TriangleFrames frames = make_triangle_frames(surfaces, make_surface_tree(surfaces));
  ASSERT_EQ(frames.groups.size(), 3u);
  for (const glm::vec3& place : places()) {
    for (const FrameGroup& group : frames.groups) {
      const GroupDistances squared = squared_distances(group, place);
      for (std::size_t lane = 0; lane < squared.size(); ++lane) {
        const double distance = true_distance(surfaces, frames, group.triangle[lane], place);
        EXPECT_NEAR(std::sqrt(squared[lane]), distance, 1e-6);
      }
    }
  }
}

TEST(FrameDistance, FindsTheLeastAmongGroupsAndStopsNoSooner) {
  const DiffusionSurfaces surfaces = tangle();
  const TriangleFrames frames = make_triangle_frames(surfaces, make_surface_tree(surfaces));
  for (const glm::vec3& place : places()) {
    std::vector<NearGroup> near;
    float min = 1e30f;
    for (std::uint32_t g = 0; g < frames.groups.size(); ++g) {
      const GroupDistances squared = squared_distances(frames.groups[g], place);
      const float own = *std::min_element(squared.begin(), squared.end());
      near.push_back({std::sqrt(own), g});
      min = std::min(min, own);
    }
    std::sort(near.begin(), near.end(), [](const NearGroup& a, const NearGroup& b) { return a.distance < b.distance; });
    // Bounds that were computed for another place differ by the distance to it, which `reach` allows for.
    for (const float reach : {1e-6f, 0.3f}) {
      std::vector<NearGroup> bounds = near;
      for (NearGroup& bound : bounds) bound.distance += 0.99f * reach;
      EXPECT_EQ(min_squared_distance(frames.groups.data(), bounds.data(), bounds.size(), reach, place), min);
    }
  }
}

TEST(FrameDistance, LeavesOutGroupsThatAreTooFar) {
  const DiffusionSurfaces surfaces = tangle();
  const TriangleFrames frames = make_triangle_frames(surfaces, make_surface_tree(surfaces));
  const glm::vec3 place(0.2f, 0.1f, 0.3f);
  // The other groups are stated to be farther away than the first one's distance, so they are not searched.
  const std::vector<NearGroup> near = {{0, 0}, {5, 1}, {5, 2}};
  const GroupDistances squared = squared_distances(frames.groups[0], place);
  EXPECT_EQ(min_squared_distance(frames.groups.data(), near.data(), 3, 0, place),
            *std::min_element(squared.begin(), squared.end()));
}

}  // namespace
}  // namespace pomona
