#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/diffusion/walk/walk_diffuser.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

shapes::Paint plain(float front, float back) { return {.front = Color(front), .back = Color(back)}; }

WalkResult walked(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points, double standard_error) {
  return WalkOnSpheres(surfaces, {.standard_error = standard_error}).at(points);
}

/// In parts of 255, of the red channel.
double stated(const WalkResult& result, std::size_t i) { return result.standard_error[i] / 255.0; }

TEST(Walk, IsHarmonicInAShell) {
  const DiffusionSurfaces shell = shapes::nested_spheres(1, 0.4, 24, plain(0, 0), plain(1, 1));
  const std::vector<glm::vec3> points{{0.5f, 0, 0}, {0, 0.7f, 0}, {0, 0, -0.9f}, {0.3f, 0.6f, -0.2f}};
  const WalkResult result = walked(shell, points, 0.5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(result.color[i].x, (1 / glm::length(points[i]) - 1) / 1.5, 4 * stated(result, i));
    EXPECT_LE(result.standard_error[i], 0.5f);
    EXPECT_EQ(result.misses[i], 0u);
  }
}

TEST(Walk, FindsASmallSphere) {
  constexpr double a = 0.03;
  const DiffusionSurfaces scene = shapes::nested_spheres(1, a, 16, plain(0, 0), plain(1, 1));
  const std::vector<glm::vec3> points{{0.05f, 0, 0}, {0, 0.2f, 0.1f}, {0, 0, -0.6f}};
  const WalkResult result = walked(scene, points, 0.5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(result.color[i].x, (1 / glm::length(points[i]) - 1) / (1 / a - 1), 4 * stated(result, i));
  }
}

/// The linear scene, turned so that no axis stays an axis; its field and its points turned with it.
struct TurnedLinearScene {
  TurnedLinearScene() : surfaces(shapes::tilted(fields::linear_scene())) {
    DiffusionSurfaces carrier;
    carrier.position = fields::points_in_linear_scene();
    for (const glm::vec3& p : carrier.position) truth.emplace_back(fields::dyadic_linear(glm::dvec3(p)));
    points = shapes::tilted(std::move(carrier)).position;
  }
  DiffusionSurfaces surfaces;
  std::vector<glm::vec3> points;
  std::vector<Color> truth;
};

TEST(Walk, KeepsLinearFieldsInATiltedBoxWithAnOpenSheet) {
  const TurnedLinearScene scene;
  const WalkResult result = walked(scene.surfaces, scene.points, 0.5);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      // One channel may vary more than the average of the three.
      EXPECT_NEAR(result.color[i][k], scene.truth[i][k], 4 * std::sqrt(3.0) * stated(result, i));
    }
  }
}

TEST(Walk, StatesItsErrorHonestly) {
  // The squared errors divided by the squared stated errors: about one on average over points and seeds.
  const TurnedLinearScene scene;
  double sum = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const WalkResult result = WalkOnSpheres(scene.surfaces, {.standard_error = 1, .seed = seed}).at(scene.points);
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const glm::dvec3 error = glm::dvec3(result.color[i]) - glm::dvec3(scene.truth[i]);
      if (result.walks[i] == 0) continue;
      sum += glm::dot(error, error) / 3 / (stated(result, i) * stated(result, i));
      ++count;
    }
  }
  EXPECT_GT(sum / count, 0.75);
  EXPECT_LT(sum / count, 1.2);
}

/// The 48 places that are equivalent by the symmetry of a sphere made from an octahedron.
std::vector<glm::vec3> mirrored(const glm::vec3& p) {
  std::vector<glm::vec3> all;
  for (int turn = 0; turn < 6; ++turn) {
    const int x = turn % 3, y = (x + 1 + turn / 3) % 3, z = 3 - x - y;
    for (int signs = 0; signs < 8; ++signs) {
      all.emplace_back((signs & 1) != 0 ? p[x] : -p[x], (signs & 2) != 0 ? p[y] : -p[y],
                       (signs & 4) != 0 ? p[z] : -p[z]);
    }
  }
  return all;
}

TEST(Walk, IsNotBiasedByWhenItStops) {
  // Near a sphere few walks get away, and these weigh much. A rule that stops because no walk has got away yet would
  // show in the mean of many estimates.
  const DiffusionSurfaces scene = shapes::nested_spheres(1, 0.4, 6, plain(0, 0), plain(1, 1));
  const std::vector<glm::vec3> points = mirrored({0.3f, 0.2f, 0.19f});
  const WalkResult truth = walked(scene, {points.front()}, 0.1);
  double sum = 0, squares = 0, runs = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const Color& color : WalkOnSpheres(scene, {.standard_error = 2, .seed = seed}).at(points).color) {
      sum += color.x;
      squares += static_cast<double>(color.x) * color.x;
      ++runs;
    }
  }
  const double mean = sum / runs, spread = (squares / runs - mean * mean) / runs;
  EXPECT_NEAR(mean, truth.color[0].x, 3 * std::sqrt(spread + stated(truth, 0) * stated(truth, 0)));
}

TEST(Walk, ThatEscapesCountsAsAMiss) {
  // Outside a ball with linear colours, harmonic functions fall with distance, and so does the share of walks that hit.
  const DiffusionSurfaces ball = fields::painted_with(
      shapes::sphere(0.5, 24), [](const glm::dvec3& p) { return glm::dvec3(0.5 + 0.8 * p.y, 0.25, 0.5); });
  for (const float distance : {0.6f, 1.0f, 3.0f}) {
    const WalkResult result = walked(ball, {{0, distance, 0}}, 1);
    const double share = 0.5 / distance, walks = result.walks[0];
    EXPECT_NEAR(result.color[0].x, 0.5 + 0.4 * share, 4 * std::sqrt(3.0) * stated(result, 0));
    EXPECT_NEAR(result.color[0].y, 0.25, 1e-6);
    // For a point outside the sphere around everything, the probability of return to it is known.
    const double met = std::min(1.0, distance > 0.51 ? 0.5 / 0.51 : share);
    EXPECT_NEAR(result.misses[0] / walks, 1 - met, 4 * std::sqrt(met * (1 - met) / walks) + 0.002);
  }
}

TEST(Walk, MeetsAnOpenSheetFromBothSides) {
  const DiffusionSurfaces scene =
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 2, plain(0.5f, 0.5f)), shapes::open_sheet(1, 0, 3, plain(1, 0)));
  const std::vector<glm::vec3> points{{0.1f, 0.3f, 0.2f},   {0.1f, -0.3f, 0.2f}, {0.1f, 1e-3f, 0.2f},
                                      {0.1f, -1e-3f, 0.2f}, {0.7f, 0, 0.1f},     {0.502f, 0, 0.1f}};
  const WalkResult result = walked(scene, points, 0.5);
  EXPECT_NEAR(result.color[0].x + result.color[1].x, 1, 4 * 1.5 * stated(result, 0));
  EXPECT_GT(result.color[0].x, 0.6f);
  EXPECT_NEAR(result.color[2].x, 1, 0.01);
  EXPECT_NEAR(result.color[3].x, 0, 0.01);
  EXPECT_NEAR(result.color[4].x, 0.5, 4 * stated(result, 4));
  EXPECT_NEAR(result.color[5].x, 0.5, 4 * stated(result, 5));
}

TEST(Walk, SeesBetweenSheetsCloserThanItsStop) {
  // Walks outside end about a hundred gaps away.
  const float gap = 4e-6f;
  const DiffusionSurfaces plates = shapes::two_plates(1, gap, plain(0.25f, 0), plain(0, 0.75f), 2);
  const DiffusionSurfaces scene = joined(plates, shapes::box({-1, -1, -1}, {1, 1, 1}, 1, plain(0, 0)));
  const WalkResult outside = walked(scene, {{0.1f, 2e-3f, 0.1f}, {0.1f, -2e-3f, 0.1f}}, 1);
  EXPECT_NEAR(outside.color[0].x, 0, 0.01);
  EXPECT_NEAR(outside.color[1].x, 0, 0.01);

  const DiffusionSurfaces wider = shapes::two_plates(1, 1e-4f, plain(0.25f, 0), plain(0, 0.75f), 2);
  const WalkResult inside = walked(wider, {{0.1f, 0, 0.1f}, {0.1f, 2.5e-5f, 0.1f}}, 1);
  EXPECT_NEAR(inside.color[0].x, 0.5, 0.02);
  EXPECT_NEAR(inside.color[1].x, 0.625, 0.03);
}

TEST(Walk, EndsOnTheSideItCameFrom) {
  DiffusionSurfaces spiky = shapes::sphere(1, 6, plain(1, 0));
  const RandomStream random({}, "tests/spikes of walks");
  for (std::size_t v = 0; v < spiky.vertex_count(); ++v) {
    spiky.position[v] *= static_cast<float>(0.4 + 1.1 * random.uniform(v));
  }
  const WalkResult result = walked(spiky, {{0, 0, 0}, {0.2f, 0.1f, 0.1f}, {1.4f, 1.4f, 0}, {-2, 0.3f, 0.2f}}, 0.5);
  EXPECT_EQ(result.color[0].x, 0);
  EXPECT_EQ(result.color[1].x, 0);
  EXPECT_EQ(result.color[2].x, 1);
  EXPECT_EQ(result.color[3].x, 1);
}

TEST(Walk, SameBitsForAnyThreadsAndNeighbours) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(40);
  const WalkResult one = WalkOnSpheres(fruit, {.standard_error = 4, .threads = {1}}).at(points);
  const WalkResult two = WalkOnSpheres(fruit, {.standard_error = 4, .threads = {2}}).at(points);
  EXPECT_EQ(one.color, two.color);
  EXPECT_EQ(one.standard_error, two.standard_error);
  std::reverse(points.begin(), points.end());
  WalkResult back = WalkOnSpheres(fruit, {.standard_error = 4, .threads = {2}}).at(points);
  std::reverse(back.color.begin(), back.color.end());
  EXPECT_EQ(one.color, back.color);
  EXPECT_NE(one.color, WalkOnSpheres(fruit, {.standard_error = 4, .seed = 1}).at(points).color);
}

TEST(WalkDiffuser, StaysInTheHullAndNamesParts) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(60);
  std::size_t last = 0;
  WalkOptions options{.standard_error = standard_error_of(Quality::draft), .threads = {1}};
  options.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 2 * points.size());
    EXPECT_EQ(done, ++last);
  };
  const std::unique_ptr<Diffuser> diffuser = make_walk_diffuser(options);
  const std::vector<DiffusionTask> tasks{{&fruit, points}, {&fruit, points}};
  const std::vector<DiffusedColors> colors = diffuser->diffuse_all(tasks);
  EXPECT_EQ(last, 2 * points.size());
  EXPECT_EQ(colors[0].color, colors[1].color);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(colors[0].color[i][k], 0.0f);
      EXPECT_LE(colors[0].color[i][k], 1.0f);
    }
    EXPECT_GE(colors[0].part[i], 0);
    EXPECT_LT(colors[0].part[i], 4);
  }
}

TEST(WalkDiffuser, OnASurfaceTakesItsColour) {
  const DiffusionSurfaces box = shapes::box({-1, -1, -1}, {1, 1, 1}, 2, plain(0.25f, 0.75f));
  const WalkResult result = walked(box, {{0.3f, 1, 0.2f}, {1, 1, 1}, {0, 0, 0}}, 4);
  EXPECT_EQ(result.color[0].x, 0.25f);
  EXPECT_EQ(result.walks[0], 0u);
  EXPECT_EQ(result.walks[1], 0u);
  EXPECT_EQ(result.color[2].x, 0.75f);
}

TEST(WalkDiffuser, WhereNothingIsMetTheNearestSideCounts) {
  // Only one walk is allowed here, and it does not meet a speck far away.
  DiffusionSurfaces specks = shapes::moved(shapes::sphere(1e-3, 1, plain(0.25f, 0)), {1000, 0, 0});
  specks = joined(specks, shapes::moved(shapes::sphere(1e-3, 1, plain(0.75f, 0)), {-1000, 0, 0}));
  const WalkResult result = WalkOnSpheres(specks, {.max_walks = 1}).at(std::vector<glm::vec3>{{100, 0, 0}});
  EXPECT_EQ(result.color[0].x, 0.25f);
  EXPECT_EQ(result.misses[0], result.walks[0]);
}

TEST(WalkDiffuser, RefusesWhatHasNoAnswer) {
  const std::unique_ptr<Diffuser> diffuser = make_walk_diffuser({.standard_error = 4});
  const std::vector<glm::vec3> origin{{0, 0, 0}};
  DiffusionSurfaces box = shapes::box({-1, -1, -1}, {1, 1, 1});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(diffuser->diffuse(box, std::vector<glm::vec3>{{nan, 0, 0}}), Error);
  EXPECT_THROW(diffuser->diffuse({}, origin), Error);
  EXPECT_THROW(make_walk_diffuser({.standard_error = 0}), Error);
  EXPECT_TRUE(diffuser->diffuse(box, {}).color.empty());
  EXPECT_EQ(diffuser->diffuse(box, std::vector<glm::vec3>{{1e30f, 0, 0}}).color.size(), 1u);
  for (glm::vec3& p : box.position) p = glm::vec3(p.x, 0, 0);
  EXPECT_THROW(diffuser->diffuse(box, origin), Error);
  box.position[0].x = nan;
  EXPECT_THROW(diffuser->diffuse(box, origin), Error);
}

}  // namespace
}  // namespace pomona
