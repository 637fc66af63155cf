#include "generator/mesh/marching_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/mesh/edges.h"

namespace pomona {
namespace {

using Values = LevelSurface::Values;

double volume_of(const ClosedSurface& solid) {
  double six = 0;
  for (const glm::uvec3& t : solid.triangle) {
    six += glm::dot(solid.point[t.x], glm::cross(solid.point[t.y], solid.point[t.z]));
  }
  return six / 6;
}

/// The distance from a point that is no vertex of the grid, and the height above it.
Values ball_and_height(const glm::dvec3& p) {
  const glm::dvec3 middle(0.011, -0.017, 0.013);
  return {glm::distance(p, middle), p.y - middle.y, 0};
}

/// The cube from -1 to 1 in n^3 cells of six tetrahedra each, which share a diagonal.
ClosedSurface solid_in_cube(int n, const std::vector<LevelSurface::Level>& levels,
                            const std::function<bool(const Values&)>& is_inside) {
  LevelSurface surface;
  const auto number = [n](const glm::ivec3& at) {
    return static_cast<std::uint32_t>((at.z * (n + 1) + at.y) * (n + 1) + at.x);
  };
  for (int z = 0; z <= n; ++z) {
    for (int y = 0; y <= n; ++y) {
      for (int x = 0; x <= n; ++x) {
        const glm::dvec3 place = 2.0 * glm::dvec3(x, y, z) / static_cast<double>(n) - 1.0;
        surface.add_vertex(place, ball_and_height(place));
      }
    }
  }
  for (std::uint32_t cell = 0; cell < static_cast<std::uint32_t>(n * n * n); ++cell) {
    const glm::ivec3 low(cell % n, cell / n % n, cell / n / n);
    std::array<int, 3> way{0, 1, 2};
    do {
      std::array<glm::ivec3, 4> corner{low, low, low, low + 1};
      ++corner[1][way[0]];
      corner[2] = corner[1];
      ++corner[2][way[1]];
      LevelSurface::Tetrahedron whole{number(corner[0]), number(corner[1]), number(corner[2]), number(corner[3])};
      const bool even = (way[1] - way[0] + 3) % 3 == 1;
      if (!even) std::swap(whole[1], whole[2]);
      surface.add(whole, levels, [&](const std::array<Values, 4>& at) {
        Values middle{};
        for (const Values& v : at) {
          for (std::size_t i = 0; i < 3; ++i) middle[i] += v[i] / 4;
        }
        return is_inside(middle);
      });
    } while (std::next_permutation(way.begin(), way.end()));
  }
  return surface.solid();
}

constexpr double radius = 0.7;
const double ball_volume = 4 * pi / 3 * radius * radius * radius;

ClosedSurface ball(int n) {
  return solid_in_cube(n, {{0, radius}}, [](const Values& v) { return v[0] < radius; });
}

TEST(MarchingTetrahedra, MakeClosedBallsWhoseVolumeConverges) {
  double error = ball_volume;
  for (const int n : {4, 8, 16}) {
    const ClosedSurface solid = ball(n);
    EXPECT_TRUE(is_closed(solid.triangle));
    const double now = std::abs(volume_of(solid) / ball_volume - 1);
    EXPECT_LT(now, 0.5 * error) << n;
    error = now;
  }
  EXPECT_LT(error, 0.02);
}

TEST(MarchingTetrahedra, PutPointsOnTheLevel) {
  // Values are moved by up to 0.03 of an edge, and the surface is straight within a cell.
  for (const glm::dvec3& p : ball(16).point) EXPECT_NEAR(ball_and_height(p)[0], radius, 0.02);
}

TEST(MarchingTetrahedra, SplitAlongSeveralFunctions) {
  const std::vector<LevelSurface::Level> levels{{0, radius}, {1, 0}};
  const ClosedSurface upper = solid_in_cube(12, levels, [](const Values& v) { return v[0] < radius && v[1] > 0; });
  const ClosedSurface lower = solid_in_cube(12, levels, [](const Values& v) { return v[0] < radius && v[1] < 0; });
  EXPECT_TRUE(is_closed(upper.triangle));
  EXPECT_TRUE(is_closed(lower.triangle));
  EXPECT_NEAR(volume_of(upper) / ball_volume, 0.5, 0.02);
  EXPECT_NEAR(volume_of(upper) + volume_of(lower), volume_of(ball(12)), 0.01 * ball_volume);
}

}  // namespace
}  // namespace pomona
