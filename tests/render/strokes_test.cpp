#include "render/strokes/scene_strokes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/compose/grow.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "generator/template/read/read_template.h"
#include "render/strokes/ink_on_picture.h"
#include "render/strokes/lens.h"
#include "render/strokes/seen_solid.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

constexpr StrokeOptions picture{.width = 400, .height = 300};

std::vector<SceneStroke> strokes_of(const Scene& scene, const StrokeOptions& options = picture) {
  return scene_strokes(scene, style_named("ink"), options);
}

double length_of(const SceneStroke& stroke) {
  double length = 0;
  for (std::size_t i = 1; i < stroke.points.size(); ++i) {
    length += glm::distance(stroke.points[i - 1].at, stroke.points[i].at);
  }
  return length;
}

double length_of(const std::vector<SceneStroke>& strokes) {
  double length = 0;
  for (const SceneStroke& stroke : strokes) length += length_of(stroke);
  return length;
}

/// Two balls side by side in the picture; the left one is nearer to the eye.
Scene overlapping_balls() {
  Scene scene = testing::ball_scene();
  scene.view.vertical_field = 0.9;
  scene.instances = {{.solid = 0, .pose = {.translation = {-0.02, 0, 0.1}}, .name = "near"},
                     {.solid = 0, .pose = {.translation = {0.02, 0, -0.1}}, .name = "far"}};
  return scene;
}

TEST(Strokes, DrawABallAsOneRoundLine) {
  const Scene scene = testing::ball_scene();
  const std::vector<SceneStroke> strokes = strokes_of(scene);
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_TRUE(strokes[0].closed);
  EXPECT_EQ(strokes[0].kind, LineKind::contour);

  // The contour of a ball: a circle about the line of sight, nearer to the eye than its centre.
  const Lens lens(scene.view, picture.width, picture.height);
  const glm::dvec3 center(0, 0.04, 0), to_eye = scene.view.eye - center;
  const double d = glm::length(to_eye), r = 0.04;
  const glm::dvec3 axis = to_eye / d, middle = center + axis * (r * r / d);
  const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0))), up = glm::cross(side, axis);
  const double radius = r * std::sqrt(1 - r * r / (d * d));
  std::vector<glm::dvec2> circle;
  for (int i = 0; i < 720; ++i) {
    const double a = 2 * pi * i / 720;
    circle.emplace_back(lens.seen(middle + radius * (side * reproducible::cos(a) + up * reproducible::sin(a))));
  }
  for (const StrokePoint& point : strokes[0].points) {
    double nearest = 1e9;
    for (const glm::dvec2& p : circle) nearest = std::min(nearest, glm::distance(p, point.at));
    EXPECT_LT(nearest, 1.0);
  }
}

TEST(Strokes, VaryInWidthAndAreHeaviestAwayFromTheLight) {
  const std::vector<SceneStroke> strokes = strokes_of(testing::ball_scene());
  ASSERT_EQ(strokes.size(), 1u);
  double light = 0, dark = 0;
  glm::dvec2 sum(0);
  for (const StrokePoint& point : strokes[0].points) sum += point.at;
  const glm::dvec2 middle = sum / static_cast<double>(strokes[0].points.size());
  for (const StrokePoint& point : strokes[0].points) {
    const glm::dvec2 out = glm::normalize(point.at - middle);
    const double away = glm::dot(out, glm::dvec2(0.6, 0.8));
    if (away > 0.8) dark = std::max(dark, point.radius);
    if (away < -0.8) light = std::max(light, point.radius);
  }
  EXPECT_GT(dark, 1.4 * light);
}

TEST(Strokes, EndWhereSomethingElseLiesBefore) {
  const std::vector<SceneStroke> strokes = strokes_of(overlapping_balls());
  ASSERT_EQ(strokes.size(), 2u);
  const SceneStroke& near = strokes[strokes[0].instance == 0 ? 0 : 1];
  const SceneStroke& far = strokes[strokes[0].instance == 0 ? 1 : 0];
  EXPECT_TRUE(near.closed);
  EXPECT_FALSE(far.closed);
  for (const StrokePoint* end : {&far.points.front(), &far.points.back()}) {
    double nearest = 1e9;
    for (const StrokePoint& point : near.points) nearest = std::min(nearest, glm::distance(point.at, end->at));
    EXPECT_LT(nearest, near.points.front().radius + 2.5) << "the outline is broken at the junction";
  }
}

/// A face seen at a grazing angle, like a leaning leaf: lines at its borders may lie on parts of it far in front of
/// them, but never on another piece.
Solid steep_strip() {
  Solid strip;
  strip.name = "strip";
  strip.mesh.position = {
      {-0.01f, 0.04f, -0.001f}, {0.05f, 0.04f, -0.001f}, {0.05f, 0.041f, -0.006f}, {-0.01f, 0.041f, -0.006f}};
  strip.mesh.normal.assign(4, glm::normalize(glm::vec3(0, 5, 1)));
  strip.mesh.color.assign(4, Color(0.2f));
  strip.mesh.part.assign(4, 0);
  strip.mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
  strip.mesh.cut_face = {-1, -1};
  strip.mesh.surface = {0, 0};
  strip.own_look().part_names = {"leaf"};
  return strip;
}

TEST(Strokes, DoNotShowThroughAThingThatLiesCloseBeforeASteepFace) {
  Scene scene = testing::ball_scene();
  scene.solids = {testing::half_ball(), steep_strip()};
  scene.instances = {{.solid = 0, .pose = {}, .name = "half"}, {.solid = 1, .pose = {}, .name = "strip"}};
  // The half is four centimetres about (0, 4 cm); the strip sticks out at its right by one.
  const Lens lens(scene.view, picture.width, picture.height);
  const double edge = lens.seen(glm::dvec3(0.037, 0.04, 0)).x;
  bool sticks_out = false;
  for (const SceneStroke& stroke : strokes_of(scene)) {
    if (stroke.instance != 1) continue;
    sticks_out = true;
    for (const StrokePoint& point : stroke.points) EXPECT_GT(point.at.x, edge);
  }
  EXPECT_TRUE(sticks_out);
}

TEST(Strokes, DrawARimOnce) {
  // A half ball, its cut face to the eye: the contour is hidden or lies under the rim.
  Scene scene = testing::ball_scene();
  scene.solids = {testing::half_ball()};
  const std::vector<SceneStroke> strokes = strokes_of(scene);
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].kind, LineKind::rim);
  EXPECT_TRUE(strokes[0].closed);
}

TEST(Strokes, LieOverNoOtherThatGoesTheSameWay) {
  const std::vector<SceneStroke> strokes = strokes_of(testing::still_life(), {.width = 800, .height = 600});
  double doubled = 0, total = 0;
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    for (std::size_t i = 1; i + 1 < strokes[s].points.size(); ++i) {
      const StrokePoint& point = strokes[s].points[i];
      const glm::dvec2 way = glm::normalize(strokes[s].points[i + 1].at - strokes[s].points[i - 1].at);
      bool beside = false;
      for (std::size_t t = 0; t < strokes.size() && !beside; ++t) {
        if (t == s) continue;
        for (std::size_t k = 1; k + 1 < strokes[t].points.size() && !beside; ++k) {
          const glm::dvec2 d = strokes[t].points[k + 1].at - strokes[t].points[k - 1].at;
          beside = glm::distance(strokes[t].points[k].at, point.at) < 0.6 * point.radius &&
                   std::fabs(glm::dot(glm::normalize(d), way)) > 0.9;
        }
      }
      total += 1;
      doubled += beside ? 1 : 0;
    }
  }
  EXPECT_LT(doubled, 0.03 * total);
}

TEST(SeenSolids, AreVisitedOnceInTheirOrderSomeAtATime) {
  // Processed together, they would take memory for all instances.
  Scene scene;
  Solid large;
  large.mesh.position.assign(600'000, glm::vec3(0, 0, 0.01f));
  large.mesh.normal.assign(large.mesh.position.size(), glm::vec3(0, 0, 1));
  scene.solids = {large, Solid{}};
  for (int i = 0; i < 5; ++i) scene.instances.push_back({0, {{1, 0, 0, 0}, {0.01 * i, 0, 0}}, ""});
  scene.instances.push_back({1, {}, ""});
  const Lens lens(scene.view, 100, 100);
  std::size_t next = 0, max = 0;
  visit_seen_solids(scene, lens, {1}, [&](std::size_t first, std::span<const SeenSolid> seen) {
    EXPECT_EQ(first, next);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(seen[i].at, scene.instances[first + i].pose.translation);
      EXPECT_EQ(seen[i].vertex.size(), scene.solids[scene.instances[first + i].solid].mesh.position.size());
    }
    next += seen.size();
    max = std::max(max, seen.size());
  });
  EXPECT_EQ(next, scene.instances.size());
  EXPECT_EQ(max, 2u);
}

TEST(Strokes, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = testing::still_life();
  const std::vector<SceneStroke> one = strokes_of(scene, {.width = 400, .height = 300, .threads = {1}});
  const std::vector<SceneStroke> three = strokes_of(scene, {.width = 400, .height = 300, .threads = {3}});
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t s = 0; s < one.size(); ++s) {
    ASSERT_EQ(one[s].points.size(), three[s].points.size());
    for (std::size_t i = 0; i < one[s].points.size(); ++i) {
      EXPECT_EQ(one[s].points[i].at, three[s].points[i].at);
      EXPECT_EQ(one[s].points[i].radius, three[s].points[i].radius);
      EXPECT_EQ(one[s].distance[i], three[s].distance[i]);
    }
  }
}

TEST(Strokes, LieALittleBeforeWhatTheyAreDrawnOn) {
  const Scene scene = testing::ball_scene();
  const double to_center = glm::length(scene.view.eye - glm::dvec3(0, 0.04, 0));
  for (const SceneStroke& stroke : strokes_of(scene)) {
    for (const double distance : stroke.distance) {
      EXPECT_LT(distance, to_center);
      EXPECT_GT(distance, to_center - 0.04);
    }
  }
}

TEST(Strokes, OfALargePictureAreThoseOfASmallOne) {
  const double small = length_of(strokes_of(testing::still_life(), {.width = 200, .height = 150}));
  const double large = length_of(strokes_of(testing::still_life(), {.width = 800, .height = 600}));
  EXPECT_NEAR(large / small, 4, 0.1);
}

/// The changes between two pictures after a step of the camera.
struct Flicker {
  double moved = 0;   ///< 99th percentile of the ink's motion in pixels, beyond the picture's own motion
  double lost = 0;    ///< share of the ink without ink within two pixels in the next picture
  int strokes = 0;    ///< difference of their numbers
  double change = 0;  ///< mean change of the inked pixels' coverage
};

Scene seen_from(Scene scene, double degrees) {
  const glm::dvec3 d = scene.view.eye - scene.view.target;
  const double c = reproducible::cos(radians(degrees)), s = reproducible::sin(radians(degrees));
  scene.view.eye = scene.view.target + glm::dvec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
  return scene;
}

/// The maximum motion of a vertex on the picture.
double max_motion(const Scene& a, const Scene& b, const StrokeOptions& options) {
  const Lens before(a.view, options.width, options.height), after(b.view, options.width, options.height);
  double max = 0;
  for (const Instance& instance : a.instances) {
    for (const glm::vec3& p : a.solids[instance.solid].mesh.position) {
      const glm::dvec3 at = instance.pose.rotation * glm::dvec3(p) + instance.pose.translation;
      max = std::max(max, glm::distance(glm::dvec2(before.seen(at)), glm::dvec2(after.seen(at))));
    }
  }
  return max;
}

double mean_change(const std::vector<SceneStroke>& a, const std::vector<SceneStroke>& b, const StrokeOptions& options) {
  InkLayer one(options.width, options.height), other(options.width, options.height);
  for (const SceneStroke& stroke : a) one.draw(stroke.points);
  for (const SceneStroke& stroke : b) other.draw(stroke.points);
  double change = 0, inked = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      change += std::fabs(one.at(x, y) - other.at(x, y));
      inked += std::max(one.at(x, y), other.at(x, y));
    }
  }
  return inked > 0 ? change / inked : 0;
}

Flicker flicker(const Scene& scene, double from, double to, const StrokeOptions& options) {
  const Scene first = seen_from(scene, from), second = seen_from(scene, to);
  const std::vector<SceneStroke> a = strokes_of(first, options), b = strokes_of(second, options);
  const double motion = max_motion(first, second, options);
  std::vector<double> moved;
  for (const SceneStroke& stroke : a) {
    for (const StrokePoint& point : stroke.points) {
      double nearest = 1e9;
      for (const SceneStroke& other : b) {
        for (const StrokePoint& there : other.points) nearest = std::min(nearest, glm::distance(there.at, point.at));
      }
      moved.push_back(std::max(0.0, nearest - motion));
    }
  }
  std::sort(moved.begin(), moved.end());
  Flicker result;
  if (moved.empty()) return result;
  result.moved = moved[moved.size() * 99 / 100];
  const auto lost = std::count_if(moved.begin(), moved.end(), [](double m) { return m > 2; });
  result.lost = static_cast<double>(lost) / static_cast<double>(moved.size());
  result.strokes = std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size()));
  result.change = mean_change(a, b, options);
  return result;
}

TEST(Strokes, DoNotFlickerWhenTheCameraMoves) {
  const Scene scene = testing::still_life();
  const StrokeOptions options{.width = 400, .height = 300};
  for (int step = 0; step < 8; ++step) {
    const Flicker found = flicker(scene, 0.2 * step, 0.2 * (step + 1), options);
    EXPECT_LE(found.moved, 0.5) << step;
    EXPECT_LE(found.lost, 0.01) << step;
    EXPECT_LE(found.strokes, 1) << step;
    EXPECT_LE(found.change, 0.2) << step;
  }
}

/// Two halves of a template as drawn, without diffused cut faces: strokes only need rims and skin.
Scene halves_of(const std::string& name) {
  const Template fruit = read_template(std::filesystem::path(POMONA_SOURCE_DIR) / "templates" / (name + ".toml"));
  GrowOptions as_drawn;
  as_drawn.as_drawn = true;
  const GrownFruit grown = grow(fruit, {}, as_drawn);
  const std::vector<Knife> knives{parse_knife("half")};
  Scene scene = gathered(slice({grown, fruit, knives, name}, nullptr).pieces);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    scene.instances[i].pose.translation.x += 0.07 * static_cast<double>(i);
  }
  scene.view = fitted_view(scene, {0.4, 0.5, 1}, 4.0 / 3);
  return scene;
}

class StrokesOfFruit : public ::testing::TestWithParam<std::string> {};

/// Wider limits than for balls: a real rim has hundreds of corners, and the outlines of an onion's roots end in the
/// skin.
TEST_P(StrokesOfFruit, DoNotFlickerWhenTheCameraMoves) {
  const Scene scene = halves_of(GetParam());
  const StrokeOptions options{.width = 400, .height = 300};
  for (int step = 0; step < 4; ++step) {
    const Flicker found = flicker(scene, 0.2 * step, 0.2 * (step + 1), options);
    EXPECT_LE(found.moved, 1) << step;
    EXPECT_LE(found.lost, 0.02) << step;
    EXPECT_LE(found.strokes, 6) << step;
    EXPECT_LE(found.change, 0.3) << step;
    RecordProperty("moved_" + std::to_string(step), std::to_string(found.moved));
    RecordProperty("lost_" + std::to_string(step), std::to_string(found.lost));
    RecordProperty("change_" + std::to_string(step), std::to_string(found.change));
    RecordProperty("strokes_" + std::to_string(step), std::to_string(found.strokes));
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, StrokesOfFruit, ::testing::Values("onion", "star_fruit"),
                         [](const auto& given) { return given.param; });

TEST(Strokes, OfAStyleWithoutInkAreNone) {
  EXPECT_TRUE(scene_strokes(testing::ball_scene(), style_named("plain"), picture).empty());
}

TEST(Strokes, OfAnEmptySceneAreNone) { EXPECT_TRUE(strokes_of(Scene{}).empty()); }

TEST(Strokes, OfWhatLiesBehindTheEyeAreNone) {
  Scene scene = testing::ball_scene();
  scene.view.target = 2.0 * scene.view.eye - scene.view.target;
  EXPECT_TRUE(strokes_of(scene).empty());
}

TEST(Strokes, StandTheEyeInTheMiddleOfAThing) {
  Scene scene = testing::ball_scene();
  scene.view.target = {0.01, 0.05, 0.02};
  scene.view.eye = {0.01, 0.05, 0.021};
  EXPECT_NO_THROW(strokes_of(scene));
}

TEST(Strokes, RefuseSizesThatCannotBe) {
  EXPECT_THROW(strokes_of(testing::ball_scene(), {.width = 0, .height = 10}), Error);
  EXPECT_THROW(strokes_of(testing::ball_scene(), {.width = 10, .height = 1 << 20}), Error);
}

TEST(InnerLines, AreWhereTheColorJumps) {
  // The half ball's cap is painted without jumps.
  const auto inner = [](const Solid& solid) {
    std::vector<SharpEdge> edges = solid_edges(solid).sharp;
    std::erase_if(edges, [](const SharpEdge& edge) { return edge.kind != LineKind::inner; });
    return edges;
  };
  EXPECT_TRUE(inner(testing::half_ball()).empty());

  // Two triangles that meet in an edge, each with its own vertices and colour.
  Solid pair;
  pair.mesh.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0}};
  pair.mesh.normal.assign(6, {0, 0, 1});
  pair.mesh.color = {Color(1, 0, 0),    Color(1, 0, 0),    Color(1, 0, 0),
                     Color(1, 1, 0.8f), Color(1, 1, 0.8f), Color(1, 1, 0.8f)};
  pair.mesh.triangle = {{0, 1, 2}, {3, 4, 5}};
  pair.mesh.cut_face = {0, 0};
  pair.mesh.surface = {-1, -1};
  const std::vector<SharpEdge> lines = inner(pair);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].opacity, 1.0f);

  // Facets of one curved face share their normals; faces that meet at an angle do not, and have a ridge.
  pair.mesh.cut_face = {0, 1};
  EXPECT_EQ(inner(pair).size(), 1u);
  for (std::size_t v = 3; v < 6; ++v) pair.mesh.normal[v] = {0, 1, 0};
  EXPECT_TRUE(inner(pair).empty());
}

}  // namespace
}  // namespace pomona
