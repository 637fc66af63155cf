#include "generator/scene/scene_file.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "tests/base/bad_files.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = POMONA_SOURCE_DIR;

TEST(SceneFile, BadScenesAreToldWhereAndWhy) {
  const auto read = [](const fs::path& file) { read_scene(file); };
  EXPECT_GE(expect_told_where_and_why(source_dir / "tests/scene/bad", read), 40);
}

TEST(SceneFile, ReadsTheSalad) {
  const fs::path file = source_dir / "scenes/salad.toml";
  const SceneDescription salad = read_scene(file);
  EXPECT_TRUE(is_scene_file(file));
  EXPECT_FALSE(is_scene_file(source_dir / "templates/tomato.toml"));
  ASSERT_TRUE(salad.bowl.has_value());
  EXPECT_NEAR(salad.bowl->profile.points.front().x, 0, 0);
  EXPECT_EQ(salad.bowl->profile.points.front().y, 0);

  // The dish must have at least 20 variants and 500 pieces, cut in three ways.
  int variants = 0;
  std::set<std::string> cuts;
  for (const PiecesDescription& entry : salad.pieces) {
    variants += entry.count;
    std::string cut;
    for (const Knife& knife : entry.knives) cut += knife.text + " ";
    cuts.insert(cut);
  }
  EXPECT_GE(variants, 20);
  EXPECT_GE(salad.total, 500);
  EXPECT_GE(cuts.size(), 3u);
}

TEST(SceneFile, NamesTheLayoutThatItLiesIn) {
  const std::string text = "format = 1\nname = \"a\"\n[[pieces]]\nname = \"b\"\ntemplate = \"tomato\"\n";
  EXPECT_EQ(parse_scene(text, "a.toml").layout, "");
  EXPECT_EQ(parse_scene("layout = \"a_layout.json\"\n" + text, "a.toml").layout, "a_layout.json");
}

TEST(SceneFile, IsKnownByAHeadingThatIsIndented) {
  const TemporaryFolder made;
  const auto written = [&](const std::string& text) {
    std::ofstream(made.path() / "a.toml") << text;
    return made.path() / "a.toml";
  };
  EXPECT_TRUE(is_scene_file(written("format = 1\n \t[[pieces]]\n")));
  EXPECT_FALSE(is_scene_file(written("format = 1\n# [[pieces]]\n")));
}

/// Every shipped scene can be read, and all files that it names exist.
/// That their templates and knives fit is tested by the program: Check.PassesEveryTemplateAndSceneOfTheTree.
TEST(SceneFile, ShippedScenesAreRead) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(source_dir / "scenes")) {
    if (entry.path().extension() != ".toml" || !is_scene_file(entry.path())) continue;
    SCOPED_TRACE(entry.path().filename().string());
    EXPECT_NO_THROW(read_scene(entry.path()));
    ++scenes;
  }
  EXPECT_GE(scenes, 9);
}

/// A knife's drawing is searched beside the scene, not in the current folder.
TEST(SceneFile, StrokesAreFoundFromItsFolder) {
  const TemporaryFolder made;
  const fs::path folder = made.path();
  fs::create_directories(folder / "drawings");
  std::ofstream(folder / "drawings/knives.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg">
<path id="wave" d="M -10,-20 L 0,-25 10,-20"/>
<path id="loop" d="M 0,0 L 20,0 10,10 10,-10"/></svg>)";
  const auto scene =
      [&](const std::string& id) {
        std::ofstream(folder / "dish.toml")
            << "format = 1\nname = \"dish\"\n[[pieces]]\nname = \"a\"\ntemplate = \"tomato\"\n"
            << "knives = [\"stroke:drawings/knives.svg#" << id << "\"]\n";
        return read_scene(folder / "dish.toml");
      };
  const KnifeCut cut = scene("wave").pieces.at(0).knives.at(0).cut;
  EXPECT_EQ(std::get<StrokeKnife>(std::get<PlaneCut>(cut)).points.size(), 3u);
  try {
    scene("loop");
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_THAT(text, testing::StartsWith((folder / "dish.toml").string() + ":6:11: error: "));
    EXPECT_THAT(text, testing::HasSubstr("knives.svg:3:"));
    EXPECT_THAT(text, testing::HasSubstr("crosses itself"));
  }
}

TEST(SceneFile, AMissingFileIsMissingInput) {
  try {
    read_scene("no/such/scene.toml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::input_missing);
  }
}

}  // namespace
}  // namespace pomona
