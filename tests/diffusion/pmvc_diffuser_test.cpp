// Requirements at every quality: reproducible bits, colours within the hull, parts, surfaces, points that see nothing,
// and bad input.
#include "generator/diffusion/pmvc/pmvc_diffuser.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "generator/base/error.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

constexpr Quality every_quality[] = {Quality::draft, Quality::final, Quality::reference};

DiffusedColors diffuse(Quality quality, const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points,
                       int threads = 0) {
  return make_pmvc_diffuser({quality, {threads}})->diffuse(surfaces, points);
}

Color color_at(Quality quality, const DiffusionSurfaces& surfaces, const glm::vec3& point) {
  return diffuse(quality, surfaces, {point}).color.front();
}

TEST(PmvcDiffuser, GivesTheSameBitsOnAnyNumberOfThreads) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(100);
  for (const Quality quality : every_quality) {
    const DiffusedColors one = diffuse(quality, fruit, points, 1);
    for (const int threads : {2, 3}) {
      const DiffusedColors several = diffuse(quality, fruit, points, threads);
      EXPECT_EQ(one.color, several.color);
      EXPECT_EQ(one.part, several.part);
    }
  }
}

TEST(PmvcDiffuser, GivesTheSameBitsOnEveryKindOfProcessor) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(100);
  const DiffusedColors best = diffuse(Quality::draft, fruit, points);
  // The smallest instruction set first: all others extend plain x86-64.
  for (const std::int64_t target : {HWY_EMU128, HWY_SSE4, HWY_AVX2, HWY_AVX3}) {
    hwy::SetSupportedTargetsForTest(0);
    if (target != HWY_EMU128 && (hwy::SupportedTargets() & target) == 0) continue;
    hwy::SetSupportedTargetsForTest(target);
    const DiffusedColors other = diffuse(Quality::draft, fruit, points);
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_EQ(best.color, other.color) << hwy::TargetName(target);
    EXPECT_EQ(best.part, other.part) << hwy::TargetName(target);
  }
}

TEST(PmvcDiffuser, NeverLeavesTheHullOfTheColours) {
  DiffusionSurfaces fruit = shapes::seeded_fruit();
  for (Color& color : fruit.front_color) color = Color(0.7f, color.g, color.b);
  for (Color& color : fruit.back_color) color = Color(0.7f, color.g, color.b);
  float low = 1, high = 0;
  for (const std::vector<Color>* colors : {&fruit.front_color, &fruit.back_color}) {
    for (const Color& color : *colors) {
      low = std::min(low, color.g);
      high = std::max(high, color.g);
    }
  }
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(200);
  for (const Quality quality : every_quality) {
    for (const Color& color : diffuse(quality, fruit, points).color) {
      EXPECT_EQ(color.r, 0.7f);
      EXPECT_GE(color.g, low);
      EXPECT_LE(color.g, high);
    }
  }
}

TEST(PmvcDiffuser, APointOnASurfaceTakesItsNearestSide) {
  // A sphere of radius 1: size 3.46, so that 1e-5 of it is 3.5e-5.
  shapes::Paint paint;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  shapes::Paint far;
  far.front = far.back = Color(0, 0, 1);
  const DiffusionSurfaces scene =
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 3, paint), shapes::box({-3, -3, -3}, {3, 3, 3}, 1, far));
  for (const Quality quality : every_quality) {
    EXPECT_EQ(color_at(quality, scene, {0.3f, 1.00002f, 0.2f}), paint.front);
    EXPECT_EQ(color_at(quality, scene, {0.3f, 0.99998f, 0.2f}), paint.back);
    EXPECT_EQ(color_at(quality, scene, {0.3f, 1, 0.2f}), paint.front);
    EXPECT_EQ(color_at(quality, scene, {1, 1, 1}), paint.front);
  }
}

TEST(PmvcDiffuser, NextToASurfaceColoursTendToItsSide) {
  shapes::Paint paint;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  const DiffusionSurfaces scene =
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 3, paint), shapes::box({-3, -3, -3}, {3, 3, 3}, 1));
  for (const Quality quality : every_quality) {
    for (const float height : {1e-4f, 1e-3f, 1e-2f}) {
      EXPECT_NEAR(color_at(quality, scene, {0.31f, 1 + height, 0.17f}).r, 1, 4 * height) << height;
      EXPECT_NEAR(color_at(quality, scene, {0.31f, 1 - height, 0.17f}).g, 1, 4 * height) << height;
    }
  }
}

TEST(PmvcDiffuser, FarFromSurfacesTheirColourRemains) {
  shapes::Paint paint;
  paint.front = paint.back = Color(0.25f, 0.5f, 0.75f);
  for (const Quality quality : every_quality) {
    for (const float far : {10.0f, 1e4f, 1e9f, 1e30f}) {
      EXPECT_EQ(color_at(quality, shapes::sphere(1, 4, paint), {far, 0.1f, 0.2f}), paint.front) << far;
    }
  }
}

TEST(PmvcDiffuser, ScaleDoesNotMatter) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(30);
  for (const float scale : {0x1p-60f, 0x1p60f}) {
    DiffusionSurfaces other = fruit;
    for (glm::vec3& p : other.position) p *= scale;
    std::vector<glm::vec3> other_points = points;
    for (glm::vec3& p : other_points) p *= scale;
    for (const Quality quality : every_quality) {
      EXPECT_EQ(diffuse(quality, fruit, points).color, diffuse(quality, other, other_points).color);
    }
  }
}

TEST(PmvcDiffuser, OpenSurfacesColourBothTheirSides) {
  shapes::Paint paint;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  const DiffusionSurfaces sheet = shapes::open_sheet(1, 0, 4, paint);
  for (const Quality quality : every_quality) {
    EXPECT_EQ(color_at(quality, sheet, {0.1f, 0.3f, 0.2f}), paint.front);
    EXPECT_EQ(color_at(quality, sheet, {0.1f, -0.3f, 0.2f}), paint.back);
    EXPECT_EQ(color_at(quality, sheet, {3, 0.2f, 0}), paint.front);
  }
}

TEST(PmvcDiffuser, WhereNothingIsSeenTheNearestSideDecides) {
  shapes::Paint paint;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  const DiffusionSurfaces speck = shapes::open_sheet(1e-3, 0, 1, paint);
  for (const Quality quality : every_quality) {
    const DiffusedColors found = diffuse(quality, speck, {{5, 1, 3}, {5, -1, 3}, {7, 0, 0}});
    EXPECT_EQ(found.color[0], paint.front);
    EXPECT_EQ(found.color[1], paint.back);
    EXPECT_EQ(found.color[2], paint.front);
    EXPECT_EQ(found.part[1], 1);
  }
}

TEST(PmvcDiffuser, ThePartIsTheOneThatWeighsMost) {
  shapes::Paint inner, outer;
  inner.front_part = inner.back_part = "core";
  outer.front_part = "skin";
  outer.back_part = "flesh";
  const DiffusionSurfaces scene = joined(shapes::sphere(0.4, 6, inner), shapes::sphere(1, 6, outer));
  for (const Quality quality : every_quality) {
    const DiffusedColors found = diffuse(quality, scene, {{0, 0.45f, 0}, {0, 0.9f, 0}, {0, 1.5f, 0}, {0, 0, 0}});
    std::vector<std::string> names;
    for (const std::int32_t part : found.part) names.push_back(scene.part_names[static_cast<std::size_t>(part)]);
    EXPECT_THAT(names, testing::ElementsAre("core", "flesh", "skin", "core"));
  }
}

TEST(PmvcDiffuser, EqualSharesGoToTheLowestPart) {
  shapes::Paint lower, upper;
  lower.front_part = lower.back_part = "one";
  upper.front_part = upper.back_part = "two";
  const DiffusionSurfaces plates = shapes::two_plates(2, 1, lower, upper);
  EXPECT_EQ(diffuse(Quality::reference, plates, {{0, 0, 0}}).part.front(), 0);
}

TEST(PmvcDiffuser, WorksFromOneTriangleToAMillion) {
  shapes::Paint paint;
  paint.front = paint.back = Color(0.25f, 0.5f, 0.75f);
  const DiffusionSurfaces one = shapes::painted({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {glm::uvec3(0, 1, 2)}, paint);
  const DiffusionSurfaces ten = shapes::box({-1, -1, -1}, {1, 1, 1}, 1, paint);
  const DiffusionSurfaces million = shapes::box({-1, -1, -1}, {1, 1, 1}, 289, paint);
  ASSERT_GE(million.triangle_count(), 1'000'000u);
  for (const DiffusionSurfaces* scene : {&one, &ten, &million}) {
    EXPECT_EQ(color_at(Quality::draft, *scene, {0.3f, 0.2f, 0.4f}), paint.front);
  }
}

TEST(PmvcDiffuser, NoPointsGiveNoColours) {
  for (const Quality quality : every_quality) EXPECT_TRUE(diffuse(quality, shapes::sphere(1, 2), {}).color.empty());
}

TEST(PmvcDiffuser, DegenerateTrianglesAreIgnored) {
  const DiffusionSurfaces sphere = shapes::sphere(1, 4);
  DiffusionSurfaces with_slivers = sphere;
  for (const glm::uvec3& t : {glm::uvec3(0, 0, 1), glm::uvec3(2, 2, 2)}) {
    with_slivers.triangle.push_back(t);
    with_slivers.surface.push_back(0);
    with_slivers.front_part.push_back(0);
    with_slivers.back_part.push_back(0);
  }
  const std::vector<glm::vec3> points{{0.2f, 0.3f, 0.1f}, {0, 0, 0}};
  for (const Quality quality : every_quality) {
    EXPECT_EQ(diffuse(quality, sphere, points).color, diffuse(quality, with_slivers, points).color);
  }
}

/// The status of the error that diffusing throws.
ExitStatus failure(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points) {
  try {
    diffuse(Quality::draft, surfaces, points);
  } catch (const Error& error) {
    return error.status();
  }
  return ExitStatus::done;
}

TEST(PmvcDiffuser, BadInputIsAnError) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const DiffusionSurfaces good = shapes::sphere(1, 2);
  DiffusionSurfaces bad_place = good, bad_color = good;
  bad_place.position[3].y = nan;
  bad_color.back_color[3].g = infinite;
  const std::vector<glm::vec3> point{{0, 0, 0}};
  EXPECT_EQ(failure(good, point), ExitStatus::done);
  EXPECT_EQ(failure(bad_place, point), ExitStatus::bad_data);
  EXPECT_EQ(failure(bad_color, point), ExitStatus::bad_data);
  EXPECT_EQ(failure(good, {{0, nan, 0}}), ExitStatus::bad_data);
  EXPECT_EQ(failure(good, {{0, 0, -infinite}}), ExitStatus::bad_data);
  EXPECT_EQ(failure(DiffusionSurfaces{}, point), ExitStatus::bad_data);
}

}  // namespace
}  // namespace pomona
