#include "generator/surface/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// Tests each pair of triangles by the definition, in long doubles; for small generic shapes.
std::size_t counted_one_by_one(const DiffusionSurfaces& surfaces, std::size_t first_of_second) {
  using Vector = glm::tvec3<long double>;
  const auto corner = [&](std::size_t t, int i) { return Vector(surfaces.position[surfaces.triangle[t][i]]); };
  const auto volume = [](const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    return glm::dot(b - a, glm::cross(c - a, d - a));
  };
  const auto pierces = [&](std::size_t s, std::size_t t) {
    const Vector a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    for (int i = 0; i < 3; ++i) {
      const Vector p = corner(s, i), q = corner(s, (i + 1) % 3);
      if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) continue;
      const bool left = volume(p, q, a, b) > 0;
      if ((volume(p, q, b, c) > 0) == left && (volume(p, q, c, a) > 0) == left) return true;
    }
    return false;
  };
  std::size_t count = 0;
  for (std::size_t s = 0; s < first_of_second; ++s) {
    for (std::size_t t = first_of_second; t < surfaces.triangle_count(); ++t) count += pierces(s, t) || pierces(t, s);
  }
  return count;
}

TEST(Crossings, OfSomeKindsAreThoseOfAllThatAreOfThem) {
  // Three balls in a row, the first two crossing, and a ring that crosses itself.
  const DiffusionSurfaces ball = shapes::sphere(1, 6);
  DiffusionSurfaces all =
      joined(joined(ball, shapes::moved(shapes::tilted(ball), {1.3, 0.1, 0.07})),
             joined(shapes::moved(ball, {9, 0, 0}), shapes::moved(shapes::torus(1, 1.4, 14, 12), {20, 0, 0})));
  const std::set<CrossingKind> kinds = crossing_kinds(all);
  ASSERT_EQ(kinds, kinds_of(all, crossing_triangles(all)));
  ASSERT_EQ(kinds.size(), 2u);
  const auto surfaces = static_cast<std::int32_t>(all.surface_names.size());
  std::set<CrossingKind> every;
  for (std::int32_t a = 0; a < surfaces; ++a) {
    for (std::int32_t b = a; b < surfaces; ++b) {
      for (const bool same : {false, true}) {
        const CrossingKind kind{a, b, same};
        every.insert(kind);
        EXPECT_EQ(crossing_kinds_of(all, {kind}).contains(kind), kinds.contains(kind));
      }
    }
  }
  EXPECT_EQ(crossing_kinds_of(all, every), kinds);
  EXPECT_TRUE(crossing_kinds_of(all, {}).empty());
}

TEST(Crossings, AreNoneWhereSurfacesLieInOneAnotherOrTouch) {
  EXPECT_TRUE(crossing_triangles(shapes::nested_spheres(1, 0.99, 12)).empty());
  EXPECT_TRUE(crossing_triangles(shapes::torus(1, 0.3, 24, 12)).empty());
  EXPECT_TRUE(crossing_triangles(shapes::two_plates(1, 0.1, {}, {}, 4)).empty());
  const DiffusionSurfaces box = shapes::box({0, 0, 0}, {1, 1, 1}, 3);
  EXPECT_TRUE(crossing_triangles(joined(box, shapes::moved(box, {1, 0, 0}))).empty());
  EXPECT_TRUE(crossing_triangles(joined(box, box)).empty());
  EXPECT_TRUE(crossing_triangles({}).empty());
}

TEST(Crossings, AreAllFound) {
  const DiffusionSurfaces ball = shapes::sphere(1, 6), other = shapes::tilted(shapes::sphere(0.7, 5));
  for (const double apart : {0.0, 0.31, 0.5, 1.1, 1.69, 1.8}) {
    const DiffusionSurfaces both = joined(ball, shapes::moved(other, {apart, 0.1 * apart, 0.07}));
    const std::vector<CrossingTriangles> found = crossing_triangles(both);
    EXPECT_EQ(found.size(), counted_one_by_one(both, ball.triangle_count())) << apart;
    for (const CrossingTriangles& pair : found) {
      EXPECT_LT(pair.first, ball.triangle_count());
      EXPECT_GE(pair.second, ball.triangle_count());
      EXPECT_FALSE(pair.same_piece);
    }
  }
}

TEST(Crossings, OfPiecesOfOneSurfaceAndOfAPieceWithItself) {
  // Two balls as one surface.
  const DiffusionSurfaces ball = shapes::sphere(1, 4);
  DiffusionSurfaces pair = joined(ball, shapes::moved(shapes::tilted(ball), {1.2, 0, 0}));
  for (std::int32_t& surface : pair.surface) surface = 0;
  EXPECT_EQ(kinds_of(pair, crossing_triangles(pair)), (std::set<CrossingKind>{{0, 0, false}}));

  // Places and triangles are enough, as a peel's offset has them while its creases are sought.
  DiffusionSurfaces bare;
  bare.position = pair.position;
  bare.triangle = pair.triangle;
  EXPECT_EQ(crossing_triangles(bare).size(), crossing_triangles(pair).size());

  // A torus so thick that it runs through itself.
  const DiffusionSurfaces torus = shapes::torus(0.2, 0.5, 25, 13);
  EXPECT_EQ(kinds_of(torus, crossing_triangles(torus)), (std::set<CrossingKind>{{0, 0, true}}));
}

TEST(Crossings, AreSeenHoweverSlight) {
  // A sheet at the topmost corner of a box: one step of a float below the corner, at it, and one step above.
  const DiffusionSurfaces box = shapes::tilted(shapes::box({0, 0, 0}, {1, 1, 1}));
  float top = 0;
  for (const glm::vec3& p : box.position) top = std::max(top, p.y);
  const auto at_height = [&](float y) {
    DiffusionSurfaces sheet = shapes::open_sheet(4, 0);
    for (glm::vec3& p : sheet.position) p.y = y;
    return crossing_triangles(joined(box, sheet));
  };
  EXPECT_FALSE(at_height(std::nextafter(top, 0.0f)).empty());
  EXPECT_TRUE(at_height(top).empty());
  EXPECT_TRUE(at_height(std::nextafter(top, 9.0f)).empty());
}

TEST(Crossings, AreTheSameOfTheSmallestFruit) {
  // Factors are powers of two, so that rounding stays the same.
  const DiffusionSurfaces ball = shapes::sphere(1, 6);
  DiffusionSurfaces both = joined(ball, shapes::moved(shapes::tilted(ball), {1.3, 0.1, 0.07}));
  const std::size_t crossings = crossing_triangles(both).size();
  ASSERT_GT(crossings, 10u);
  for (int k = 0; k < 12; ++k) {
    for (glm::vec3& p : both.position) p *= 0.5f;
    EXPECT_EQ(crossing_triangles(both).size(), crossings) << k;
  }
}

TEST(Crossings, OfWhatIsNotANumberAreNone) {
  DiffusionSurfaces ball = shapes::sphere(1, 4);
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    ball.position[3].x = odd;
    EXPECT_NO_THROW(crossing_triangles(ball));
  }
  for (glm::vec3& p : ball.position) p = glm::vec3(1);
  EXPECT_TRUE(crossing_triangles(ball).empty());
}

}  // namespace
}  // namespace pomona
