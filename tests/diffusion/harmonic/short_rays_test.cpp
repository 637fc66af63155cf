#include "generator/diffusion/harmonic/short_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "generator/base/random.h"
#include "generator/mesh/triangle_distance.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// Triangles somewhat larger than a cell, around the point where the rays start.
std::vector<SeenTriangle> random_triangles(std::size_t count) {
  const RandomStream random({}, "tests/seen triangles");
  std::uint64_t n = 0;
  const auto place = [&] {
    const glm::vec3 p(2.4 * random.uniform(n) - 1.2, 2.4 * random.uniform(n + 1) - 1.2,
                      2.4 * random.uniform(n + 2) - 1.2);
    n += 3;
    return p;
  };
  std::vector<SeenTriangle> all;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 a = place(), b = place(), c = place();
    all.push_back({a, b, c});
  }
  return all;
}

/// The place on the ray (as a fraction of its length) and the weights of b and c, by Cramer's rule in doubles; nothing
/// for a ray that misses the triangle. `is_close` where rounding may decide.
struct ExactHit {
  double fraction = 0, b = 0, c = 0;
  bool is_close = false, hits = false;
};
ExactHit exact_hit(const SeenTriangle& t, const glm::vec3& towards) {
  const glm::dvec3 a(t.a), u = glm::dvec3(t.b) - a, v = glm::dvec3(t.c) - a, d(towards);
  const glm::dmat3 system(d, -u, -v);
  const double determinant = glm::determinant(system);
  ExactHit hit;
  if (std::fabs(determinant) < 1e-4) return {0, 0, 0, true, false};
  hit.fraction = glm::determinant(glm::dmat3(a, -u, -v)) / determinant;
  hit.b = glm::determinant(glm::dmat3(d, a, -v)) / determinant;
  hit.c = glm::determinant(glm::dmat3(d, -u, a)) / determinant;
  const double min = std::min({hit.b, hit.c, 1 - hit.b - hit.c, hit.fraction, 1 - hit.fraction});
  hit.hits = min >= 0;
  hit.is_close = std::fabs(min) < 1e-3;
  return hit;
}

TEST(ShortRays, EndOnTheNearestTriangle) {
  const RandomStream random({}, "tests/cells of short rays");
  const std::vector<SeenTriangle> triangles = random_triangles(300);
  int hits = 0, free = 0;
  for (std::size_t first = 0; first + 3 <= triangles.size(); first += 3) {
    const glm::vec3 low(-random.uniform(first), -random.uniform(first + 1), -random.uniform(first + 2));
    ShortRays rays(low);
    for (std::size_t t = first; t < first + 3; ++t) rays.meet(triangles[t], static_cast<std::uint32_t>(t));
    for (int k = 0; k < 8; ++k) {
      const glm::vec3 towards = low + glm::vec3(k & 1, k >> 1 & 1, k >> 2);
      EXPECT_EQ(rays.towards(k), towards);
      bool is_close = false;
      std::optional<std::size_t> nearest;
      ExactHit best;
      for (std::size_t t = first; t < first + 3; ++t) {
        const ExactHit hit = exact_hit(triangles[t], towards);
        is_close = is_close || hit.is_close;
        if (!hit.hits || (nearest && best.fraction <= hit.fraction)) continue;
        nearest = t;
        best = hit;
      }
      if (is_close) continue;
      const auto found = rays.hit(k);
      ASSERT_EQ(found.has_value(), nearest.has_value());
      (found ? hits : free) += 1;
      if (!found) continue;
      EXPECT_EQ(found->triangle, *nearest);
      EXPECT_NEAR(found->fraction, best.fraction, 1e-3);
      EXPECT_NEAR(found->weight.y, best.b, 2e-3);
      EXPECT_NEAR(found->weight.z, best.c, 2e-3);
      EXPECT_NEAR(found->weight.x + found->weight.y + found->weight.z, 1, 1e-6);
      const SeenTriangle& t = triangles[*nearest];
      EXPECT_EQ(found->sees_front, glm::dot(glm::cross(t.b - t.a, t.c - t.a), towards) < 0);
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(free, 300);
}

TEST(ShortRays, PassNoEdgeBetweenNeighbours) {
  // Small spheres around the point: if the point is the cell's middle, their corners and edges lie on the rays.
  const RandomStream random({}, "tests/cells of short rays");
  for (std::uint64_t n = 0; n < 300; n += 3) {
    const glm::vec3 low =
        n == 0 ? glm::vec3(-0.5f)
               : -glm::vec3(0.1f) - 0.8f * glm::vec3(random.uniform(n), random.uniform(n + 1), random.uniform(n + 2));
    for (const int pieces : {1, 2, 3, 6}) {
      const DiffusionSurfaces ball = shapes::sphere(0.1, pieces);
      ShortRays rays(low);
      for (std::uint32_t t = 0; t < ball.triangle_count(); ++t) {
        const glm::uvec3& v = ball.triangle[t];
        rays.meet({ball.position[v.x], ball.position[v.y], ball.position[v.z]}, t);
      }
      for (int k = 0; k < 8; ++k) {
        ASSERT_TRUE(rays.hit(k).has_value());
        EXPECT_FALSE(rays.hit(k)->sees_front);
      }
    }
  }
}

TEST(ShortRays, AreHiddenByWhatLiesAtTheCornerAndNotByWhatLiesBehind) {
  const auto wall_at = [](float x) { return SeenTriangle{{x, -5, -5}, {x, 10, -5}, {x, -5, 10}}; };
  for (const auto& [x, hides] : {std::pair{0.4f, true}, {0.5f, true}, {0.51f, false}, {-0.1f, false}}) {
    ShortRays rays(glm::vec3(-0.5f));
    rays.meet(wall_at(x), 7);
    EXPECT_EQ(rays.hit(7).has_value(), hides) << x;
    EXPECT_EQ(rays.hit(0).has_value(), x == -0.1f) << x;
  }
}

TEST(ShortRays, FindNothingBeforeAnythingIsMet) {
  for (int k = 0; k < 8; ++k) EXPECT_FALSE(ShortRays(glm::vec3(-0.3f)).hit(k).has_value());
}

/// The min over a fine grid of weights, refined twice around the min.
double min_distance(const SeenTriangle& t) {
  constexpr int steps = 60;
  double min = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const glm::dvec3 p = (static_cast<double>(steps - i - j) * glm::dvec3(t.a) +
                            static_cast<double>(i) * glm::dvec3(t.b) + static_cast<double>(j) * glm::dvec3(t.c)) /
                           static_cast<double>(steps);
      min = std::min(min, glm::length(p));
    }
  }
  return min;
}

TEST(ShortRays, NearestWeightsAreNoFartherThanAnyOthers) {
  std::array<int, 8> regions{};  // counts of triangles, by which weights are 0
  for (const SeenTriangle& t : random_triangles(1000)) {
    const glm::vec3 w = nearest_weights(glm::vec3(0), t.a, t.b, t.c);
    EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-5);
    for (int k = 0; k < 3; ++k) EXPECT_GE(w[k], -1e-6f);
    const double away = glm::length(glm::dvec3(w.x * t.a + w.y * t.b + w.z * t.c));
    EXPECT_LE(away, min_distance(t) + 1e-5);
    ++regions.at(static_cast<std::size_t>((w.x == 0 ? 1 : 0) | (w.y == 0 ? 2 : 0) | (w.z == 0 ? 4 : 0)));
  }
  // Within, on each edge, at each corner.
  for (std::size_t region = 0; region < 7; ++region) EXPECT_GT(regions.at(region), 0) << region;
}

}  // namespace
}  // namespace pomona
