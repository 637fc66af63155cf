#include "generator/scene/layout_file.h"

#include <sys/stat.h>

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/heap_shapes.h"

namespace pomona {
namespace {

Scene two_balls() {
  Scene scene;
  scene.solids = {heap_shapes::ball(0.02), heap_shapes::wedge(0.03, 60)};
  scene.instances = {{0, {glm::dquat(0.5, 0.5, -0.5, 0.5), {0.123456, 1e-6, -0.2}}, "first"},
                     {1, {glm::dquat(1, 0, 0, 0), {0.1, 0.2, 0.3}}, "second \"quoted\""}};
  return scene;
}

void expect_error(const std::string& json, const std::string& message) {
  const Scene scene = two_balls();
  try {
    poses_for(parse_layout(json, "l.json"), scene.solids, scene.instances);
    ADD_FAILURE() << "was read: " << json;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    EXPECT_THAT(to_string(error.diagnostics().front()), testing::StartsWith(message));
  }
}

TEST(LayoutFile, ComesBackExactly) {
  const Scene scene = two_balls();
  const std::string text = write_layout(scene);
  const std::vector<Pose> poses = poses_for(parse_layout(text, "l.json"), scene.solids, scene.instances);
  Scene again = scene;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_TRUE(poses[i].rotation == scene.instances[i].pose.rotation);
    EXPECT_TRUE(poses[i].translation == scene.instances[i].pose.translation);
    again.instances[i].pose = poses[i];
  }
  EXPECT_EQ(write_layout(again), text);
}

TEST(LayoutFile, SaysWhereItIsWrong) {
  expect_error("{\"format\": 1,\n \"instances\": [}", "l.json:2:16: error: this is not JSON");
  expect_error("{\"format\": 2}", "l.json:1:12: error: format should be 1");
  expect_error("{\"format\": 1}", "l.json:1:1: error: \"instances\" is missing");
  expect_error("{\"format\": 1, \"instances\": [\n {\"name\": \"first\"}]}", "l.json:2:2: error: \"solid\" is missing");
  expect_error(
      "{\"format\": 1, \"instances\": [{\"name\": \"first\", \"solid\": \"ball\",\n"
      "\"rotation\": [1, 0, 0], \"translation\": [0, 0, 0]}]}",
      "l.json:2:13: error: should be 4 numbers");
  expect_error(
      "{\"format\": 1, \"instances\": [{\"name\": \"first\", \"solid\": \"ball\",\n"
      "\"rotation\": [1, 0, 0, 0], \"translation\": [0, \"up\", 0]}]}",
      "l.json:2:46: error: should be a number");
}

/// Devices and pipes are refused without being opened, which might never end.
TEST(LayoutFile, IsAFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.json").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder / "zero.json");
  for (const char* name : {"pipe.json", "zero.json"}) {
    try {
      read_layout(folder / name);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::input_missing);
      EXPECT_THAT(error.what(), testing::HasSubstr("is a device or a pipe, not a file"));
    }
  }
}

TEST(LayoutFile, ThatIsMissingIsToldInTheScene) {
  SceneDescription scene;
  scene.file = "folder/scene.toml";
  scene.layout = "none.json";
  scene.layout_place = {scene.file, 3, 10, {}};
  try {
    layout_of(scene);
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                testing::StartsWith("folder/scene.toml:3:10: error: layout \"none.json\": there is no such file"));
  }
}

TEST(LayoutFile, BelongsToItsScene) {
  const Scene scene = two_balls();
  std::string text = write_layout(scene);
  expect_error("{\"format\": 1, \"instances\": []}", "l.json:1:28: error: \"first\" has no place here");
  text.replace(text.find("\"ball\""), 6, "\"bell\"");
  expect_error(text, "l.json:4:14: error: \"first\" is of solid \"ball\" in the scene");
}

}  // namespace
}  // namespace pomona
