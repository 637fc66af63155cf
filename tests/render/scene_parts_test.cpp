#include "render/strokes/scene_parts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/strokes/lens.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

constexpr int width = 320, height = 240;

/// Half a ball, its cut face (part 1) towards the eye, in front of its skin (part 0).
Scene half_ball_scene() {
  Scene scene = testing::ball_scene();
  scene.solids = {testing::half_ball()};
  scene.solids[0].own_look().part_names = {"skin", "flesh"};
  return scene;
}

std::size_t pixels_of(const PartMap& map, std::int32_t part) {
  return static_cast<std::size_t>(std::count(map.part.begin(), map.part.end(), part));
}

TEST(SceneParts, AreThoseOneLooksAt) {
  const Scene scene = half_ball_scene();
  const PartMap map = scene_parts(scene, width, height);
  EXPECT_EQ(map.names, scene.solids[0].look->part_names);

  // The face is a disc of 4 cm at the distance of the target, seen at right angles.
  const Lens lens(scene.view, width, height);
  const double radius = 0.04 / lens.pixel_size(lens.seen({0, 0.04, 0}).z);
  EXPECT_NEAR(static_cast<double>(pixels_of(map, 1)), 3.14159265 * radius * radius,
              0.02 * 3.14159265 * radius * radius);
  EXPECT_EQ(map.at(width / 2, height / 2), 1);
  for (const int x : {0, width - 1}) {
    for (const int y : {0, height - 1}) EXPECT_EQ(map.at(x, y), -1);
  }
}

TEST(SceneParts, HideWhatLiesBehind) {
  Scene scene = half_ball_scene();
  scene.view.eye.z = -scene.view.eye.z;  // from behind: only skin
  const PartMap map = scene_parts(scene, width, height);
  EXPECT_GT(pixels_of(map, 0), 1000u);
  EXPECT_EQ(pixels_of(map, 1), 0u);
}

TEST(SceneParts, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = half_ball_scene();
  EXPECT_EQ(scene_parts(scene, width, height, {1}).part, scene_parts(scene, width, height, {3}).part);
}

TEST(SceneParts, OfAnEmptySceneAreNone) {
  const PartMap map = scene_parts(Scene{}, 8, 6);
  EXPECT_EQ(map.part.size(), 48u);
  EXPECT_EQ(pixels_of(map, -1), 48u);
}

}  // namespace
}  // namespace pomona
