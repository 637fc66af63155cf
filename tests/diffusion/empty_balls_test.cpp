#include "generator/diffusion/walk/empty_balls.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/walk/walk_draws.h"
#include "generator/diffusion/walk/walk_end.h"
#include "generator/mesh/triangle_distance.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

EmptyBalls balls_of(const DiffusionSurfaces& surfaces) {
  return {make_triangle_frames(surfaces, make_surface_tree(surfaces)), {1}};
}

std::vector<glm::dvec3> random_places(std::size_t count) {
  const RandomStream random({}, "tests/places for balls");
  std::vector<glm::dvec3> places;
  for (std::uint64_t n = 0; places.size() < count; n += 3) {
    places.emplace_back(2 * random.uniform(n) - 1, 2 * random.uniform(n + 1) - 1, 2 * random.uniform(n + 2) - 1);
  }
  return places;
}

/// The normalised distance, by trying all triangles.
double true_distance(const DiffusionSurfaces& surfaces, const TriangleFrames& frames, const glm::dvec3& place) {
  double min = 1e30;
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
    auto [a, b, c] = corners(surfaces, t);
    a = frames.normalized(a), b = frames.normalized(b), c = frames.normalized(c);
    const glm::dvec3 w = nearest_weights(place, a, b, c);
    min = std::min(min, glm::length(place - (w.x * a + w.y * b + w.z * c)));
  }
  return min;
}

void expect_empty_and_large(const DiffusionSurfaces& surfaces, const std::vector<glm::dvec3>& places) {
  const EmptyBalls balls = balls_of(surfaces);
  for (const glm::dvec3& place : places) {
    const double distance = true_distance(surfaces, balls.frames(), place), radius = balls.radius_at(place);
    EXPECT_LE(radius, distance);
    EXPECT_GE(radius, 0.6 * distance - 2 * EmptyBalls::slack);
    if (distance < 0.003) {
      EXPECT_GE(radius, distance - 2 * EmptyBalls::slack);
    }
  }
}

TEST(EmptyBalls, AreEmptyAndLargeInAFruit) { expect_empty_and_large(shapes::seeded_fruit(), random_places(300)); }

TEST(EmptyBalls, AreEmptyAndLargeNextToSurfaces) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const TriangleFrames frames = make_triangle_frames(fruit, make_surface_tree(fruit));
  std::vector<glm::dvec3> places = random_places(300);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 corner(fruit.position[i * 31]);
    places[i] = frames.normalized(corner) + 0.002 * places[i];
  }
  expect_empty_and_large(fruit, places);
}

/// Queries may lie anywhere in the cube, its sides included.
TEST(EmptyBalls, AreEmptyAndLargeOnTheSidesOfTheCube) {
  std::vector<glm::dvec3> places = random_places(300);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] *= EmptyBalls::half_edge;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // A side, an edge or a corner.
      const std::size_t at = i >> (2 * axis) & 3;
      if (at < 2) places[i][static_cast<int>(axis)] = at == 0 ? EmptyBalls::half_edge : -EmptyBalls::half_edge;
    }
  }
  expect_empty_and_large(shapes::seeded_fruit(), places);
  const DiffusionSurfaces aside =
      joined(shapes::moved(shapes::sphere(0.1, 4), {1, 0.2, 0.3}), shapes::open_sheet(1, -1));
  expect_empty_and_large(aside, places);
}

TEST(EmptyBalls, OfThreeTriangles) {
  DiffusionSurfaces three = shapes::open_sheet(2, 0.3, 1);
  three = joined(three, shapes::open_sheet(0.5, 0, 1));
  three.triangle.pop_back();
  expect_empty_and_large(three, random_places(300));
}

TEST(EmptyBalls, OfNeedles) {
  // A fan of a thousand needles a millionth wide.
  std::vector<glm::vec3> position{{0, 0, 0}};
  std::vector<glm::uvec3> triangle;
  for (std::uint32_t i = 0; i <= 1000; ++i) {
    position.emplace_back(1, 1e-6f * static_cast<float>(i), 0.1f * static_cast<float>(i % 2) * 1e-6f);
    if (i > 0) triangle.emplace_back(0, i, i + 1);
  }
  expect_empty_and_large(shapes::painted(position, triangle, {}), random_places(100));
}

TEST(WalkDraws, DirectionsAreUniform) {
  const RandomStream stream({3, 4}, "tests/directions");
  Draws draws(stream, 0);
  glm::dvec3 sum(0), squares(0);
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 d = random_direction(draws);
    EXPECT_NEAR(glm::length(d), 1, 1e-12);
    sum += d;
    squares += d * d;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(sum[k] / count, 0, 4 * std::sqrt(1.0 / 3 / count));
    EXPECT_NEAR(squares[k] / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
  }
}

TEST(WalkDraws, IcosahedraGiveMeansOfPolynomials) {
  const RandomStream stream({}, "tests/icosahedra");
  Draws draws(stream, 0);
  glm::dvec3 first(0);
  for (int i = 0; i < 2000; ++i) {
    const auto corners = random_icosahedron(draws);
    double x2y2 = 0, x4 = 0, odd = 0;
    for (const glm::dvec3& c : corners) {
      x2y2 += c.x * c.x * c.y * c.y / 12;
      x4 += c.x * c.x * c.x * c.x / 12;
      odd += c.x + c.y * c.z * c.z + c.z * c.z * c.z * c.z * c.z;
    }
    EXPECT_NEAR(x2y2, 1.0 / 15, 1e-12);
    EXPECT_NEAR(x4, 0.2, 1e-12);
    EXPECT_NEAR(odd, 0, 1e-12);
    first += corners[0];
  }
  EXPECT_LT(glm::length(first) / 2000, 4 / std::sqrt(2000.0));
}

TEST(WalkDraws, ReturnsToASphereByPoissonsKernel) {
  const RandomStream stream({}, "tests/returns");
  Draws draws(stream, 0);
  constexpr int count = 20000;
  for (const double distance : {2.0001, 2.2, 4.0, 2e9}) {
    // The mean of a polynomial over the places of return is the value of its harmonic extension at the mirrored point.
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, -2, 3));
    const double mirrored = 2 / distance;
    double first = 0, second = 0;
    for (int i = 0; i < count; ++i) {
      const glm::dvec3 place = random_return(distance * axis, 2, draws);
      EXPECT_NEAR(glm::length(place), 2, 1e-9);
      const double cosine = glm::dot(place, axis) / 2;
      first += cosine / count;
      second += (1.5 * cosine * cosine - 0.5) / count;
    }
    EXPECT_NEAR(first, mirrored, 4 / std::sqrt(3.0 * count));
    EXPECT_NEAR(second, mirrored * mirrored, 4 / std::sqrt(5.0 * count));
  }
}

/// A ball with spikes, each a single vertex pulled out or in by half; its front faces outwards.
DiffusionSurfaces spiky_ball() {
  DiffusionSurfaces ball = shapes::sphere(1, 6);
  const RandomStream random({}, "tests/spikes");
  for (std::size_t v = 0; v < ball.vertex_count(); ++v) {
    ball.position[v] *= static_cast<float>(0.4 + 1.1 * random.uniform(v));
  }
  return ball;
}

TEST(SideNextTo, IsRightAroundSpikes) {
  const DiffusionSurfaces ball = spiky_ball();
  const EmptyBalls balls = balls_of(ball);
  const std::vector<glm::dvec3> around = random_places(200);
  for (std::size_t v = 0; v < ball.vertex_count(); ++v) {
    // The surface has one radius in each direction, so a place's side follows from the radius of the triangle in its
    // direction.
    const glm::dvec3 corner = balls.frames().normalized(glm::dvec3(ball.position[v]));
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 place = corner + 1e-4 * around[(v + static_cast<std::size_t>(i) * 7) % around.size()];
      const SurfaceSide side = side_next_to(ball, balls, place);
      const glm::dvec3 from_middle = place * balls.frames().radius + balls.frames().middle;
      bool is_inside = false;
      for (std::uint32_t t = 0; t < ball.triangle_count(); ++t) {
        const auto [a, b, c] = corners(ball, t);
        const double whole = glm::dot(a, glm::cross(b, c));
        const glm::dvec3 w(glm::dot(from_middle, glm::cross(b, c)) / whole,
                           glm::dot(a, glm::cross(from_middle, c)) / whole,
                           glm::dot(a, glm::cross(b, from_middle)) / whole);
        if (w.x >= 0 && w.y >= 0 && w.z >= 0) is_inside = w.x + w.y + w.z < 1;
      }
      EXPECT_EQ(side.side == SideOf::back, is_inside) << "next to vertex " << v;
    }
  }
}

/// Three triangles with a common corner. The point sees the first one most from the front, the second one hardly. The
/// third one lies in a plane with the point and the way to the first: a sheet seen edge-on hides nothing.
TEST(SideNextTo, IsNotHiddenBehindASheetSeenEdgeOn) {
  const std::vector<glm::vec3> position{{0, 0, 0},           {-1, 1, 0.5f}, {-1, 1, -0.5f}, {-1, -0.2f, -0.25f},
                                        {-1, -0.2f, 0.375f}, {-1, -1, 0},   {-0.5f, -1, 0}};
  for (const bool is_turned : {false, true}) {
    const std::vector<glm::uvec3> triangle{is_turned ? glm::uvec3(0, 2, 1) : glm::uvec3(0, 1, 2), {0, 3, 4}, {0, 5, 6}};
    const DiffusionSurfaces sheets = shapes::painted(position, triangle, {});
    const EmptyBalls balls = balls_of(sheets);
    const glm::dvec3 point = balls.frames().normalized(glm::dvec3(0)) + glm::dvec3(1e-4, 0, 0);
    ASSERT_EQ(balls.nearest_triangles(point).size(), 3u);
    const SurfaceSide side = side_next_to(sheets, balls, point);
    EXPECT_EQ(side.triangle, 0u);
    EXPECT_EQ(side.side, is_turned ? SideOf::front : SideOf::back);
    EXPECT_NEAR(side.distance, 1e-4 * balls.frames().radius, 1e-12);
  }
}

}  // namespace
}  // namespace pomona
