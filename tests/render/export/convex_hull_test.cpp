#include "render/export/convex_hull.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/moments.h"
#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

double volume_of(const ConvexHull& hull) { return moments_of(hull.position, hull.triangle, {}).mass; }

/// The hull is closed, and no vertex is in front of any face.
void expect_convex(const ConvexHull& hull) {
  std::map<std::pair<unsigned, unsigned>, int> edges;
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3 a(hull.position[t.x]), b(hull.position[t.y]), c(hull.position[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    for (const glm::vec3& p : hull.position) EXPECT_LT(glm::dot(glm::dvec3(p) - a, glm::normalize(area)), 1e-8);
    for (int k = 0; k < 3; ++k) {
      const unsigned from = t[k], to = t[(k + 1) % 3];
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  for (const auto& [edge, sum] : edges) EXPECT_EQ(sum, 0);
}

/// Points at a distance of a third of a centimetre on and in a box of 2 x 3 x 4 cm.
std::vector<glm::vec3> grid() {
  std::vector<glm::vec3> points;
  for (int x = 0; x <= 6; ++x)
    for (int y = 0; y <= 9; ++y)
      for (int z = 0; z <= 12; ++z) points.push_back(glm::vec3(x, y, z) / 300.0f);
  return points;
}

TEST(ConvexHull, OfABoxIsItsCorners) {
  const ConvexHull hull = convex_hull(grid());
  EXPECT_EQ(hull.position.size(), 8u);
  EXPECT_EQ(hull.triangle.size(), 12u);
  EXPECT_NEAR(volume_of(hull), 0.02 * 0.03 * 0.04, 1e-11);
  expect_convex(hull);
}

TEST(ConvexHull, OfABallHasAsManyVerticesAsAskedForAndMostOfItsVolume) {
  const Solid ball = named::ball("ball", 0.1f, 30, Color(0.5f));
  const double whole = volume_of(convex_hull(ball.mesh.position, 100000));
  EXPECT_GT(whole, 0.998 * 4.0 / 3 * 3.14159265 * 0.001);
  for (const std::size_t most : {16u, 64u}) {
    const ConvexHull hull = convex_hull(ball.mesh.position, most);
    EXPECT_EQ(hull.position.size(), most);
    EXPECT_GT(volume_of(hull), (most == 64 ? 0.87 : 0.55) * whole);
    EXPECT_LT(volume_of(hull), whole);
    expect_convex(hull);
    for (const glm::vec3& p : hull.position)
      EXPECT_NE(std::find(ball.mesh.position.begin(), ball.mesh.position.end(), p), ball.mesh.position.end());
  }
}

TEST(ConvexHull, OfPointsThatAreGivenTwiceIsThatOfEachOnce) {
  const std::vector<glm::vec3> round = named::ball("ball", 0.1f, 12, Color(0.5f)).mesh.position;
  const std::vector<glm::vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
      one{{1, 2, 3}};
  for (const std::vector<glm::vec3>& points : {round, grid(), flat, line, one}) {
    std::vector<glm::vec3> twice = points;
    twice.insert(twice.end(), points.begin(), points.end());
    twice.insert(twice.end(), points.begin(), points.end());
    const ConvexHull of_each = convex_hull(points), of_all = convex_hull(twice);
    EXPECT_EQ(of_all.position, of_each.position);
    EXPECT_EQ(of_all.triangle, of_each.triangle);
  }
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfPoints) {
  std::vector<glm::vec3> points = named::ball("ball", 0.1f, 12, Color(0.5f)).mesh.position;
  const ConvexHull one = convex_hull(points);
  std::reverse(points.begin(), points.end());
  const ConvexHull other = convex_hull(points);
  EXPECT_EQ(one.position, other.position);
  EXPECT_EQ(one.triangle, other.triangle);
}

/// A drum has two flat faces of many corners, which CGAL divides as memory happens to lie: of copies at other addresses
/// it made other triangles.
TEST(ConvexHull, DividesFlatFacesTheSameWayEachTime) {
  std::vector<glm::vec3> drum;
  for (int x = -5; x <= 5; ++x)
    for (int z = -5; z <= 5; ++z)
      if (x * x + z * z <= 25) drum.insert(drum.end(), {glm::vec3(x, 0, z), glm::vec3(x, 4, z)});
  const ConvexHull once = convex_hull(drum, 100);
  EXPECT_EQ(once.position.size(), 24u) << "places within a face or an edge are no corners";
  EXPECT_EQ(once.triangle.size(), 2 * once.position.size() - 4) << "closed";
  std::vector<std::vector<char>> holes;
  for (int run = 0; run < 20; ++run) {
    holes.emplace_back(static_cast<std::size_t>(1000 + 977 * run));
    EXPECT_EQ(convex_hull(drum, 100).triangle, once.triangle);
  }
}

TEST(ConvexHull, OfWhatIsFlatOrNothingIsEmpty) {
  EXPECT_TRUE(convex_hull({}).triangle.empty());
  const std::vector<glm::vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  EXPECT_TRUE(convex_hull(line).triangle.empty());
  const std::vector<glm::vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5f, 0.3f, 0}, {0.2f, 0.7f, 0}};
  EXPECT_TRUE(convex_hull(flat).triangle.empty());
}

/// The coarse hull starts with the farthest points along the axes, even if other points are farther out.
TEST(ConvexHull, OfFewVerticesReachesAsFarAsThePointsAlongEveryAxis) {
  for (int thin = 0; thin < 3; ++thin) {
    std::vector<glm::vec3> points = named::ball("ball", 0.1f, 12, Color(0.5f)).mesh.position;
    for (glm::vec3& p : points) p[thin] *= 0.2f;
    const ConvexHull hull = convex_hull(points, 14);
    ASSERT_EQ(hull.position.size(), 14u);
    glm::vec3 low(1), high(-1);
    for (const glm::vec3& p : hull.position) low = glm::min(low, p), high = glm::max(high, p);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(high[axis], axis == thin ? 0.1f * 0.2f : 0.1f) << "thin along " << thin;
      EXPECT_EQ(low[axis], -high[axis]) << "thin along " << thin;
    }
  }
}

}  // namespace
}  // namespace pomona
