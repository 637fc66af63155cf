// Diffusion by OpenGL: the oracles of positive mean values, independence of batches and contexts, and errors.
#include <cmath>
#include <limits>
#include <thread>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/diffusion/resolved_colors.h"
#include "render/diffusion/gl_diffuser.h"
#include "render/diffusion/gl_pmvc.h"
#include "tests/diffusion/fields.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

/// One context for most tests: opening one takes longer than most of them.
const Diffuser& at_quality(Quality quality) {
  static const auto draft = make_gl_diffuser({.quality = Quality::draft});
  static const auto fine = make_gl_diffuser({.quality = Quality::final});
  return quality == Quality::draft ? *draft : *fine;
}

std::vector<Color> colors_at(Quality quality, const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points) {
  return at_quality(quality).diffuse(surfaces, points).color;
}

Color color_at(Quality quality, const DiffusionSurfaces& surfaces, const glm::vec3& point) {
  return colors_at(quality, surfaces, {point}).front();
}

constexpr Quality usual_qualities[] = {Quality::draft, Quality::final};

/// Inner sphere 1, outer sphere 0.
DiffusionSurfaces shell(int n) {
  shapes::Paint inner, outer;
  inner.front = inner.back = Color(1);
  outer.front = outer.back = Color(0);
  return joined(shapes::sphere(0.4, n, inner), shapes::sphere(1, n, outer));
}

TEST(GlDiffuser, ReproducesLinearFieldsInAClosedSceneWithOccluders) {
  const DiffusionSurfaces scene = fields::linear_scene();
  const std::vector<glm::vec3> points = fields::points_in_linear_scene();
  for (const Quality quality : usual_qualities) {
    const std::vector<Color> colors = colors_at(quality, scene, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(glm::length(glm::dvec3(colors[i]) - fields::dyadic_linear(glm::dvec3(points[i]))), 1e-5) << i;
    }
  }
}

TEST(GlDiffuser, ShellHasTheValuesOfItsExactIntegral) {
  const std::vector<glm::vec3> points{{0, 0.5f, 0}, {0, 0.7f, 0}, {0.9f, 0, 0}, {0.4041f, 0.4041f, 0.4041f}};
  const std::vector<double> exact{0.576000, 0.136582, 0.025501, 0.136582};
  const std::vector<Color> draft = colors_at(Quality::draft, shell(32), points);
  const std::vector<Color> fine = colors_at(Quality::final, shell(32), points);
  const std::vector<Color> converged = make_gl_diffuser({Quality::reference, {}, {}})->diffuse(shell(48), points).color;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(draft[i].x, exact[i], 3.0 / 255) << i;
    EXPECT_NEAR(fine[i].x, exact[i], 1.0 / 255) << i;
    EXPECT_NEAR(converged[i].x, exact[i], 1e-3) << i;
  }
}

TEST(GlDiffuser, PlatesAndPolynomial) {
  shapes::Paint lower, upper;
  lower.front = lower.back = Color(1);
  upper.front = upper.back = Color(0);
  const DiffusionSurfaces plates = shapes::two_plates(200, 1, lower, upper, 8);
  EXPECT_NEAR(color_at(Quality::final, plates, {0.3f, -0.25f, 0.2f}).x, 0.75, 1.0 / 255);

  const DiffusionSurfaces sphere = fields::painted_with(shapes::sphere(1, 32), [](const glm::dvec3& p) {
    const double cosine = p.y / glm::length(p);
    return glm::dvec3(0.5 * (3 * cosine * cosine - 1));
  });
  EXPECT_NEAR(color_at(Quality::final, sphere, {0, 0.5f, 0}).x, 0.2648, 1.0 / 255);
}

TEST(GlDiffuser, KeepsTheErrorsThatDraftAndFinalPromise) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(250);
  const std::vector<Color> truth = make_pmvc_diffuser({Quality::reference, {}})->diffuse(fruit, points).color;
  EXPECT_LE(fields::errors_of(colors_at(Quality::draft, fruit, points), truth).rms, 1);
  const fields::Errors fine = fields::errors_of(colors_at(Quality::final, fruit, points), truth);
  EXPECT_LE(fine.rms, 0.4);
  EXPECT_LE(fine.p95, 1);
  EXPECT_LE(fine.max, 2);
}

TEST(GlDiffuser, NeverLeavesTheHullOfTheColours) {
  DiffusionSurfaces fruit = shapes::seeded_fruit();
  for (Color& color : fruit.front_color) color.r = 0.7f;
  for (Color& color : fruit.back_color) color.r = 0.7f;
  float low = 1, high = 0;
  for (const std::vector<Color>* colors : {&fruit.front_color, &fruit.back_color}) {
    for (const Color& color : *colors) {
      low = std::min(low, color.g);
      high = std::max(high, color.g);
    }
  }
  for (const Color& color : colors_at(Quality::draft, fruit, shapes::points_on_section_of_seeded_fruit(100))) {
    EXPECT_EQ(color.r, 0.7f);
    EXPECT_GE(color.g, low);
    EXPECT_LE(color.g, high);
  }
}

TEST(GlDiffuser, APointOnASurfaceTakesItsNearestSide) {
  shapes::Paint paint, far;
  paint.front = Color(1, 0, 0);
  paint.back = Color(0, 1, 0);
  far.front = far.back = Color(0, 0, 1);
  const DiffusionSurfaces scene =
      joined(shapes::box({-1, -1, -1}, {1, 1, 1}, 3, paint), shapes::box({-3, -3, -3}, {3, 3, 3}, 1, far));
  EXPECT_EQ(color_at(Quality::draft, scene, {0.3f, 1.00002f, 0.2f}), paint.front);
  EXPECT_EQ(color_at(Quality::draft, scene, {0.3f, 0.99998f, 0.2f}), paint.back);
  EXPECT_EQ(color_at(Quality::draft, scene, {1, 1, 1}), paint.front);
  for (const float height : {1e-4f, 1e-3f, 1e-2f}) {
    EXPECT_NEAR(color_at(Quality::draft, scene, {0.31f, 1 + height, 0.17f}).r, 1, 4 * height) << height;
    EXPECT_NEAR(color_at(Quality::draft, scene, {0.31f, 1 - height, 0.17f}).g, 1, 4 * height) << height;
  }
}

TEST(GlDiffuser, FarAwayAndUnseenTheNearestSideDecides) {
  shapes::Paint paint;
  paint.front = paint.back = Color(0.25f, 0.5f, 0.75f);
  for (const float far : {10.0f, 1e4f, 1e9f, 1e30f}) {
    EXPECT_EQ(color_at(Quality::draft, shapes::sphere(1, 4, paint), {far, 0.1f, 0.2f}), paint.front) << far;
  }
  paint.back = Color(0, 1, 0);
  const DiffusionSurfaces speck = shapes::open_sheet(1e-3, 0, 1, paint);
  const DiffusedColors found = at_quality(Quality::draft).diffuse(speck, std::vector<glm::vec3>{{5, 1, 3}, {5, -1, 3}});
  EXPECT_EQ(found.color[0], paint.front);
  EXPECT_EQ(found.color[1], paint.back);
  EXPECT_EQ(found.part[1], 1);
}

TEST(GlDiffuser, ThePartIsTheOneThatWeighsMost) {
  shapes::Paint inner, outer;
  inner.front_part = inner.back_part = "core";
  outer.front_part = "skin";
  outer.back_part = "flesh";
  const DiffusionSurfaces scene = joined(shapes::sphere(0.4, 6, inner), shapes::sphere(1, 6, outer));
  const std::vector<glm::vec3> points{{0, 0.45f, 0}, {0, 0.9f, 0}, {0, 1.5f, 0}, {0, 0, 0}};
  const DiffusedColors found = at_quality(Quality::draft).diffuse(scene, points);
  std::vector<std::string> names;
  for (const std::int32_t part : found.part) names.push_back(scene.part_names[static_cast<std::size_t>(part)]);
  EXPECT_THAT(names, testing::ElementsAre("core", "flesh", "skin", "core"));
}

TEST(GlDiffuser, WorksFromOneTriangleToManyAndWithManyParts) {
  shapes::Paint paint;
  paint.front = paint.back = Color(0.25f, 0.5f, 0.75f);
  const DiffusionSurfaces one = shapes::painted({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {glm::uvec3(0, 1, 2)}, paint);
  const DiffusionSurfaces ten = shapes::box({-1, -1, -1}, {1, 1, 1}, 1, paint);
  const DiffusionSurfaces many = shapes::box({-1, -1, -1}, {1, 1, 1}, 60, paint);
  for (const DiffusionSurfaces* scene : {&one, &ten, &many}) {
    EXPECT_EQ(color_at(Quality::draft, *scene, {0.3f, 0.2f, 0.4f}), paint.front);
  }

  // Next to a triangle of its own part.
  DiffusionSurfaces parted = shapes::sphere(1, 8);
  for (std::size_t t = 0; t < parted.triangle_count(); ++t) parted.back_part[t] = static_cast<std::int32_t>(t);
  const glm::uvec3& corner = parted.triangle[437];
  const glm::vec3 middle = (parted.position[corner.x] + parted.position[corner.y] + parted.position[corner.z]) / 3.0f;
  const std::vector<glm::vec3> beside{0.99f * middle};
  EXPECT_THAT(at_quality(Quality::draft).diffuse(parted, beside).part, testing::ElementsAre(437));
  EXPECT_TRUE(colors_at(Quality::draft, ten, {}).empty());
}

TEST(GlDiffuser, EqualTrianglesAreTakenInTheirOrder) {
  // A thousand copies of one triangle: no split separates them, and the first must win.
  shapes::Paint paint;
  DiffusionSurfaces stack = shapes::painted({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, {glm::uvec3(0, 2, 1)}, paint);
  for (std::uint32_t i = 1; i < 1000; ++i) {
    shapes::Paint other;
    other.front = other.back = Color(static_cast<float>(i) / 1000);
    stack = joined(stack, shapes::painted({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, {glm::uvec3(0, 2, 1)}, other));
  }
  for (const float height : {0.2f, -0.2f}) {
    const Color found = color_at(Quality::draft, stack, {0, height, -0.3f});
    const Color expected = height > 0 ? paint.front : paint.back;
    EXPECT_NEAR(glm::distance(found, expected), 0, 1e-6) << height;
  }
}

TEST(GlDiffuser, ABatchGivesTheBitsOfSingleCalls) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit(), ball = shell(6), turned = shapes::tilted(shell(5));
  const std::vector<glm::vec3> some = shapes::points_on_section_of_seeded_fruit(150);
  const std::vector<glm::vec3> few{{0.1f, 0.5f, 0}, {0.2f, -0.4f, 0.3f}, {0, 0.6f, 0}};
  const std::vector<DiffusionTask> tasks{
      {&ball, few}, {&fruit, some}, {&turned, few}, {&ball, {few.data() + 1, 2}}, {&turned, {}}};
  const std::vector<DiffusedColors> batch = at_quality(Quality::draft).diffuse_all(tasks);
  ASSERT_EQ(batch.size(), tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const DiffusedColors alone = at_quality(Quality::draft).diffuse(*tasks[i].surfaces, tasks[i].points);
    EXPECT_EQ(batch[i].color, alone.color) << i;
    EXPECT_EQ(batch[i].part, alone.part) << i;
  }
  EXPECT_TRUE(at_quality(Quality::draft).diffuse_all({}).empty());
}

TEST(GlDiffuser, AFieldMayBeAskedAgainAndOutliveItsDiffuser) {
  const DiffusionSurfaces ball = shell(6);
  const std::vector<glm::vec3> points{{0.1f, 0.5f, 0}, {0.2f, -0.4f, 0.3f}};
  const std::unique_ptr<ColorField> field = make_gl_diffuser({.quality = Quality::draft})->field(ball);
  EXPECT_EQ(field->at(points).color, colors_at(Quality::draft, ball, points));
  EXPECT_EQ(field->at(points).color, field->at(points).color);
}

TEST(GlDiffuser, WorksOnAnyThread) {
  const DiffusionSurfaces ball = shell(6);
  const std::vector<glm::vec3> points{{0.1f, 0.5f, 0}, {0.2f, -0.4f, 0.3f}};
  const std::vector<Color> expected = colors_at(Quality::draft, ball, points);
  std::vector<std::vector<Color>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<Color>& colors : found) {
    threads.emplace_back([&] { colors = colors_at(Quality::draft, ball, points); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<Color>& colors : found) EXPECT_EQ(colors, expected);
}

TEST(GlDiffuser, EveryRouteGivesTheSameColours) {
  const DiffusionSurfaces fruit = shapes::seeded_fruit();
  const std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(40);
  const auto usual = make_gl_diffuser({.quality = Quality::draft, .route = GlRoute::osmesa});
  const std::vector<Color> expected = usual->diffuse(fruit, points).color;
  for (const GlRoute route : {GlRoute::device, GlRoute::surfaceless, GlRoute::osmesa}) {
    const auto diffuser = make_gl_diffuser({.quality = Quality::draft, .route = route});
    EXPECT_STREQ(diffuser->name(), "gl");
    EXPECT_FALSE(diffuser->device().empty());
    EXPECT_LE(fields::errors_of(diffuser->diffuse(fruit, points).color, expected).max, 0.01) << to_string(route);
  }
}

/// Two fruits as passed to the card, and points in them.
struct TwoFruits {
  DiffusionSurfaces surfaces[2] = {shapes::seeded_fruit(), shell(20)};
  RayFrame frame[2];
  std::shared_ptr<const RaySurfaces> rays[2];
  SightTask task[2];

  TwoFruits() {
    const std::vector<glm::vec3> points[2] = {shapes::points_on_section_of_seeded_fruit(300), {{0.1f, 0.5f, 0}}};
    for (std::size_t i = 0; i < 2; ++i) {
      const SurfaceTree tree = make_surface_tree(surfaces[i]);
      frame[i] = ray_frame(surfaces[i], tree);
      rays[i] = std::make_shared<const RaySurfaces>(ray_surfaces(surfaces[i], tree, frame[i]));
      task[i] = {i, &frame[i], [same = rays[i]] { return same; }, {}};
      for (const glm::vec3& point : points[i]) task[i].eye.push_back(frame[i].normalized(point));
    }
  }
};

TEST(GlPmvc, SmallBuffersChangeNothing) {
  const TwoFruits fruits;
  GlContext context;
  const CurrentGl gl(context);
  const auto values = [&](std::size_t max_bytes) {
    const GlRayCaster caster(gl, context, max_bytes);
    GlFruits on_card(max_bytes);
    GlPmvc pmvc(gl, caster, on_card, {.lines = 32, .fine_lines = 64, .max_scatter = 1.0 / 255});
    pmvc.start(std::vector<const SightTask*>{&fruits.task[0], &fruits.task[1]});
    EXPECT_EQ(on_card.place(0).has_value(), max_bytes > std::size_t{1} << 22) << "room for both";
    std::vector<glm::dvec3> colors;
    for (const auto& task : pmvc.finish()) {
      for (const PointSight& sight : task) colors.push_back(sight.value.color);
    }
    return colors;
  };
  const std::size_t just_one = fruits.rays[0]->triangle.size() * sizeof(RayTriangle);
  EXPECT_EQ(values(just_one), values(std::size_t{1} << 27));
  EXPECT_THROW(values(just_one - 1), Error);
}

TEST(GlPmvc, KnowsPointsThatMayLieOnASurface) {
  const TwoFruits fruits;
  const SurfaceTree tree = make_surface_tree(fruits.surfaces[0]);
  std::vector<glm::vec3> points = shapes::points_on_section_of_seeded_fruit(300);
  const std::size_t inside = points.size();
  for (std::size_t t = 0; t < fruits.surfaces[0].triangle_count(); t += 50) {
    const auto [a, b, c] = corners(fruits.surfaces[0], static_cast<std::uint32_t>(t));
    points.emplace_back(0.5 * a + 0.3 * b + 0.2 * c);
  }
  SightTask task = fruits.task[0];
  task.eye.clear();
  for (const glm::vec3& point : points) task.eye.push_back(fruits.frame[0].normalized(point));

  GlContext context;
  const CurrentGl gl(context);
  const GlRayCaster caster(gl, context);
  GlFruits on_card(caster.max_bytes());
  GlPmvc pmvc(gl, caster, on_card, {.lines = 8});
  pmvc.start(std::vector<const SightTask*>{&task});
  const std::vector<PointSight> seen = pmvc.finish().front();
  const SidesOfPoints sides = sides_on_surfaces(fruits.surfaces[0], tree, points, {});
  std::size_t suspected = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(seen[i].near_surface || !sides[i]) << i;
    suspected += i < inside && seen[i].near_surface ? 1 : 0;
  }
  EXPECT_LT(suspected, inside / 20) << "hardly any is asked again";
}

TEST(GlDiffuser, KeepsFruitsByValueNotByPlace) {
  DiffusionSurfaces ball = shell(6);
  const std::vector<glm::vec3> points{{0.1f, 0.5f, 0}, {0.2f, -0.4f, 0.3f}};
  const std::vector<Color> first = colors_at(Quality::draft, ball, points);
  EXPECT_EQ(colors_at(Quality::draft, DiffusionSurfaces(ball), points), first) << "a copy";
  std::swap(ball.front_color, ball.back_color);
  for (Color& color : ball.front_color) color *= 0.5f;
  const std::vector<Color> changed = colors_at(Quality::draft, ball, points);
  EXPECT_NE(changed, first);
  EXPECT_EQ(changed, make_gl_diffuser({.quality = Quality::draft})->diffuse(ball, points).color);
}

/// The status of the error that diffusing throws.
ExitStatus failure(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& points) {
  try {
    colors_at(Quality::draft, surfaces, points);
  } catch (const Error& error) {
    return error.status();
  }
  return ExitStatus::done;
}

TEST(GlDiffuser, BadInputIsAnError) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const DiffusionSurfaces good = shapes::sphere(1, 2);
  DiffusionSurfaces bad_place = good, bad_color = good, no_area = good;
  bad_place.position[3].y = nan;
  bad_color.back_color[3].g = infinite;
  for (glm::vec3& position : no_area.position) position = glm::vec3(1);
  const std::vector<glm::vec3> point{{0, 0, 0}};
  EXPECT_EQ(failure(good, point), ExitStatus::done);
  EXPECT_EQ(failure(bad_place, point), ExitStatus::bad_data);
  EXPECT_EQ(failure(bad_color, point), ExitStatus::bad_data);
  EXPECT_EQ(failure(no_area, point), ExitStatus::bad_data);
  EXPECT_EQ(failure(good, {{0, nan, 0}}), ExitStatus::bad_data);
  EXPECT_EQ(failure(good, {{0, 0, -infinite}}), ExitStatus::bad_data);
  EXPECT_EQ(failure(DiffusionSurfaces{}, point), ExitStatus::bad_data);
}

TEST(Shaders, ThoseThatComputeCompile) {
  GlContext context;
  const CurrentGl gl(context);
  int compiled = 0;
  for (const std::string& name : shader_names()) {
    if (name.find(".comp.") == std::string::npos) continue;
    EXPECT_NO_THROW(Program::compute(gl, name)) << name;
    ++compiled;
  }
  EXPECT_EQ(compiled, 3);
}

TEST(GlContext, KnowsSoftwareByItsName) {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "virgl (LLVMPIPE (LLVM 12.0.0, 256 bits))",
                           "zink Vulkan 1.3(llvmpipe (LLVM 17.0.6, 256 bits) (LLVM_LLVMPIPE))",
                           "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)))", "Software Rasterizer",
                           "D3D12 (Microsoft Basic Render Driver)"}) {
    EXPECT_TRUE(is_software_renderer(name)) << name;
  }
  for (const char* name : {"NVIDIA H100 PCIe/PCIe/SSE2", "AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6)",
                           "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "NVIDIA GeForce RTX 4090/PCIe/SSE2"}) {
    EXPECT_FALSE(is_software_renderer(name)) << name;
  }
}

}  // namespace
}  // namespace pomona
