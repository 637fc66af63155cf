// Cuts along closed surfaces.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/cut/cut.h"
#include "generator/knife/parse_knife.h"
#include "generator/surface/bodies.h"
#include "tests/cut/cut_checks.h"
#include "tests/cut/solid_shapes.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::expect_whole;
using shapes::solid_knife;

constexpr double pi = 3.14159265358979323846;

double whole_volume(const DiffusionSurfaces& surfaces) {
  double sum = 0;
  for (const Bodies::Body& body : find_bodies(surfaces).bodies) sum += body.volume;
  return sum;
}

TEST(Carve, TakesABallOutOfABall) {
  const DiffusionSurfaces fruit = shapes::sphere(0.05, 8, shapes::skin_paint());
  const double whole = whole_volume(fruit);
  const ClosedSurface ball = shapes::ball({0.05, 0.003, 0.002}, 0.02, 8);
  const Cut result = cut(fruit, std::vector{solid_knife(ball)});
  ASSERT_EQ(result.pieces.size(), 2u);
  expect_whole(result, whole);
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_GT(result.pieces[0].volume, result.pieces[1].volume) << "what is left comes first";
  // The lens that two balls have in common.
  const double d = std::sqrt(0.05 * 0.05 + 0.003 * 0.003 + 0.002 * 0.002), R = 0.05, r = 0.02;
  const double lens =
      pi * (R + r - d) * (R + r - d) * (d * d + 2 * d * r - 3 * r * r + 2 * d * R + 6 * r * R - 3 * R * R) / (12 * d);
  EXPECT_NEAR(result.pieces[1].volume / lens, 1, 0.06);
}

TEST(Carve, LeavesAHollowWhereTheKnifeIsInTheMiddle) {
  const DiffusionSurfaces fruit = shapes::sphere(0.05, 8, shapes::skin_paint());
  const double whole = whole_volume(fruit);
  const Cut result = cut(fruit, std::vector{solid_knife(shapes::ball({0.01, 0, 0}, 0.02, 8))});
  ASSERT_EQ(result.pieces.size(), 2u);
  expect_whole(result, whole);
  EXPECT_NEAR(result.pieces[1].volume, 4. / 3 * pi * 0.02 * 0.02 * 0.02, 1e-6);
}

TEST(Carve, SaysWhenAKnifeMisses) {
  const DiffusionSurfaces fruit = shapes::sphere(0.05, 5, shapes::skin_paint());
  for (const ClosedSurface& solid : {shapes::ball({0.1, 0, 0}, 0.02, 4), shapes::ball({0, 0, 0}, 0.2, 4)}) {
    const Cut result = cut(fruit, std::vector{solid_knife(solid)});
    ASSERT_EQ(result.pieces.size(), 1u);
    EXPECT_TRUE(result.pieces[0].closed);
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_EQ(result.warnings[0], "knife \"solid\" cuts nothing: it misses the fruit, or holds all of it");
  }
}

TEST(Carve, GoesWithPlanesBeforeAndAfter) {
  const DiffusionSurfaces fruit = shapes::nested_spheres(0.05, 0.02, 6);
  const double whole = whole_volume(fruit);
  const Knife ball = solid_knife(shapes::ball({0.03, 0.01, 0.004}, 0.03, 8));
  for (const std::vector<Knife>& knives :
       {std::vector{parse_knife("half"), ball}, std::vector{ball, parse_knife("half")},
        std::vector{parse_knife("dice:20mm"), ball}, std::vector{parse_knife("crinkle:20mm"), ball},
        std::vector{parse_knife("wedges:5"), ball},
        std::vector{ball, solid_knife(shapes::ball({0.01, 0.03, 0.002}, 0.03, 8)), parse_knife("half")}}) {
    const Cut result = cut(fruit, knives);
    SCOPED_TRACE(knives.front().text + " " + knives.back().text);
    EXPECT_GE(result.pieces.size(), 4u);
    expect_whole(result, whole);
  }
}

/// Edges along an axis, corners in the knife's planes: where ties decide, no piece may be inside out, and both sides
/// must agree.
TEST(Carve, PartsABoxWhoseEdgesLieInTheKnives) {
  const DiffusionSurfaces box = shapes::box({-0.015, -0.015, -0.015}, {0.015, 0.015, 0.015}, 2, shapes::skin_paint());
  for (const char* ball :
       {"ball:6mm,at=0.7cm,0,0", "ball:6mm,at=0,0.7cm,0", "ball:10mm,at=0,0,0", "ball:6mm,at=1.5cm,0,0"}) {
    SCOPED_TRACE(ball);
    const Cut result = cut(box, std::vector{parse_knife("half"), parse_knife(ball)});
    expect_whole(result, whole_volume(box));
    ASSERT_EQ(result.pieces.size(), 4u);
    std::vector<double> volumes;
    for (const CutPiece& piece : result.pieces) {
      EXPECT_GT(piece.volume, 0);
      EXPECT_TRUE(piece.closed);
      volumes.push_back(piece.volume);
    }
    std::sort(volumes.begin(), volumes.end());
    EXPECT_NEAR(volumes[0] / volumes[1], 1, 1e-3) << "two halves of what the ball takes";
    EXPECT_NEAR(volumes[2] / volumes[3], 1, 1e-6) << "two halves of what it leaves";
  }
}

TEST(Carve, TakesACavityWithItsHome) {
  // A ball inside, through which a rod of another body sticks out of the fruit.
  const DiffusionSurfaces fruit =
      joined(shapes::sphere(0.05, 8, shapes::skin_paint()),
             shapes::box({-0.004, 0.01, -0.004}, {0.004, 0.07, 0.004}, 2, shapes::skin_paint()));
  const double whole = shapes::volume_of(cut(fruit, {}));
  const Cut result = cut(fruit, std::vector{solid_knife(shapes::ball({0, 0, 0}, 0.045, 8))});
  expect_whole(result, whole);
  ASSERT_EQ(result.pieces.size(), 2u);
  for (const CutPiece& piece : result.pieces) EXPECT_GT(piece.volume, 0);
}

TEST(Carve, CutsGrainsSheetsAndChambers) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const double whole = whole_volume(fruit);
  const Cut result =
      cut(fruit, std::vector{parse_knife("half"), solid_knife(shapes::ball({0.02, 0.005, 0.003}, 0.025, 10)),
                             solid_knife(shapes::rod({-0.01, -0.1, 0.002}, 0.012, 0.2, 24))});
  EXPECT_GE(result.pieces.size(), 4u);
  expect_whole(result, whole);
}

/// A vertex to be diffused exists once; other vertices at its place have a surface's colour.
TEST(Carve, FacesShareTheVerticesWhereTheyMeet) {
  const DiffusionSurfaces fruit = shapes::sphere(0.05, 6, shapes::skin_paint());
  const Cut result =
      cut(fruit, std::vector{parse_knife("half"), solid_knife(shapes::ball({0.03, 0.01, 0.004}, 0.03, 8))});
  const CrossSection& section = result.section;
  std::set<std::array<float, 3>> seen;
  std::vector<std::set<int>> knives(section.position.size());
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    const CutFace& face = section.faces[static_cast<std::size_t>(section.cut[t])];
    for (int i = 0; i < 3; ++i) knives[section.triangle[t][i]].insert(face.knife);
  }
  int on_both = 0;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (!section.interior[v] || knives[v].empty()) continue;
    const glm::vec3& p = section.position[v];
    EXPECT_TRUE(seen.insert({p.x, p.y, p.z}).second);
    on_both += knives[v].size() == 2 ? 1 : 0;
  }
  EXPECT_GT(on_both, 10);
}

TEST(Carve, ColorsBothSidesOfWhatItCuts) {
  shapes::Paint core;
  core.front = {0.1f, 0.2f, 0.7f};
  core.back = {0.9f, 0.7f, 0.1f};
  const DiffusionSurfaces fruit = shapes::nested_spheres(0.05, 0.02, 8, shapes::skin_paint(), core);
  const Cut result = cut(fruit, std::vector{solid_knife(shapes::block({0.0021, -0.1, -0.1}, {0.1, 0.1, 0.1}))});
  int fronts = 0, backs = 0;
  const CrossSection& section = result.section;
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    const glm::uvec3& c = section.triangle[t];
    const double out = glm::length(section.position[c.x] + section.position[c.y] + section.position[c.z]) / 3;
    for (int i = 0; i < 3; ++i) {
      if (section.interior[c[i]] || glm::length(section.position[c[i]]) > 0.03f) continue;
      const bool front = glm::distance(section.color[c[i]], core.front) < 1e-5f;
      EXPECT_TRUE(front || glm::distance(section.color[c[i]], core.back) < 1e-5f);
      if (std::fabs(out - 0.02) > 5e-4) {
        EXPECT_EQ(front, out > 0.02);
      }
      (front ? fronts : backs) += 1;
    }
  }
  EXPECT_GT(fronts, 100);
  EXPECT_GT(backs, 100);
}

TEST(Carve, ShadesABowlSmoothlyAndKeepsCreases) {
  const DiffusionSurfaces fruit = shapes::sphere(0.05, 8, shapes::skin_paint());
  const glm::dvec3 center(0.05, 0.003, 0.002);
  const Cut bowl = cut(fruit, std::vector{solid_knife(shapes::ball(center, 0.02, 8))});
  ASSERT_EQ(bowl.section.faces.size(), 1u);
  ASSERT_EQ(bowl.section.normal.size(), bowl.section.triangle.size());
  for (std::size_t t = 0; t < bowl.section.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 out = glm::normalize(glm::dvec3(bowl.section.position[bowl.section.triangle[t][i]]) - center);
      EXPECT_GT(glm::dot(out, glm::dvec3(bowl.section.normal[t][static_cast<std::size_t>(i)])), 0.9995);
    }
  }

  // A rod that ends within the fruit: its end is flat, and meets the side in a crease.
  const Cut hole = cut(fruit, std::vector{solid_knife(shapes::rod({0.003, -0.02, 0.002}, 0.012, 0.2, 48))});
  std::size_t level = 0, upright = 0;
  for (const std::array<glm::vec3, 3>& normals : hole.section.normal) {
    for (const glm::vec3& n : normals) {
      EXPECT_NEAR(glm::length(n), 1, 1e-5);
      (std::fabs(n.y) < 1e-3f ? level : upright) += 1;
      if (std::fabs(n.y) >= 1e-3f) {
        EXPECT_FLOAT_EQ(n.y, -1);
      }
    }
  }
  EXPECT_GT(level, 100u);
  EXPECT_GT(upright, 100u);
}

TEST(Carve, IsFinerNextToTheSurfaces) {
  const DiffusionSurfaces fruit = shapes::sphere(0.05, 60, shapes::skin_paint());
  const Cut result = cut(fruit, std::vector{solid_knife(shapes::block({-0.1, 0.0051, -0.1}, {0.1, 0.1, 0.1}))});
  double max_inside = 0, max_at_skin = 0;
  for (const glm::uvec3& t : result.section.triangle) {
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 &a = result.section.position[t[i]], &b = result.section.position[t[(i + 1) % 3]];
      const double out = glm::length(0.5f * (a + b)), length = glm::distance(a, b);
      if (out < 0.02) max_inside = std::max(max_inside, length);
      if (out > 0.048) max_at_skin = std::max(max_at_skin, length);
    }
  }
  const double size = glm::length(bounds_of(fruit).size());
  EXPECT_LT(max_inside, 2 * size / 40);
  EXPECT_GT(max_inside, 1.3 * max_at_skin);
  EXPECT_LT(max_at_skin, 0.0035);  // 1.4 times: 1.4 mm, the fruit's own edges, and a third of 2 mm
}

TEST(Carve, IsTheSameForAnyNumberOfThreads) {
  const DiffusionSurfaces fruit = shapes::nested_spheres(0.05, 0.02, 6);
  const std::vector<Knife> knives{parse_knife("half"), solid_knife(shapes::ball({0.03, 0.01, 0.004}, 0.03, 8))};
  CutOptions one, two;
  one.threads = {1};
  two.threads = {2};
  shapes::expect_same(cut(fruit, knives, one), cut(fruit, knives, two));
}

TEST(Carve, RefusesASurfaceWithAHole) {
  ClosedSurface open = shapes::ball({0, 0, 0}, 0.02, 2);
  open.triangle.pop_back();
  EXPECT_THROW(cut(shapes::sphere(0.05, 2, shapes::skin_paint()), std::vector{solid_knife(open)}), Error);
}

}  // namespace
}  // namespace pomona
