// Ground truth of pictures through the program (--aov).
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_pomona.h"

namespace pomona::testing {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Half a cherry, small and coarse.
Outcome cut_cherry(const std::vector<std::string>& more, const fs::path& folder) {
  return run_pomona(
      with({"cut", "cherry", "--knife", "half", "--detail", "0.3", "--quality", "draft", "--size", "96x72", "--quiet"},
           more),
      folder);
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Aov, GoesIntoItsFolderBesideThePicture) {
  const TemporaryFolder folder;
  const Outcome outcome = cut_cherry({"-o", "x.png", "--aov", "truth"}, folder.path());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(names_in(folder / "truth"),
              ::testing::ElementsAre("amodal_1.png", "annotations.json", "depth.png", "fruit.png", "instance.png",
                                     "normal.png", "part.png", "section.png"));
  const auto all = nlohmann::json::parse(bytes_of(folder / "truth/annotations.json"));
  EXPECT_EQ(all.at("images").at(0).at("file_name"), "x.png");
  EXPECT_EQ(all.at("categories").at(0).at("name"), "cherry");
  ASSERT_EQ(all.at("annotations").size(), 2u);
  EXPECT_EQ(all.at("fruits").size(), 1u) << "of one cherry";

  // Neither --aov nor the number of threads changes the picture; a second run replaces the folder's files.
  ASSERT_EQ(cut_cherry({"-o", "y.png"}, folder.path()).status, 0);
  EXPECT_EQ(bytes_of(folder / "x.png"), bytes_of(folder / "y.png"));
  fs::copy(folder / "truth", folder / "before");
  ASSERT_EQ(cut_cherry({"-o", "x.png", "--aov", "truth/", "--threads", "1"}, folder.path()).status, 0);
  for (const std::string& name : names_in(folder / "before"))
    EXPECT_EQ(bytes_of(folder / ("truth/" + name)), bytes_of(folder / ("before/" + name))) << name;
}

TEST(Aov, ComesWithWholeFruitAndScenesToo) {
  const TemporaryFolder folder;
  std::ofstream(folder / "two.toml") << "format = 1\nname = \"two\"\nseed = 5\n[[pieces]]\nname = \"cherries\"\n"
                                        "template = \"cherry\"\ncount = 2\nknives = [\"half\"]\n";
  const std::vector<std::string> coarse{"--detail", "0.3", "--quality", "draft", "--size", "96x72", "--quiet"};
  ASSERT_EQ(run_pomona(with({"scene", "two.toml", "-o", "s.png", "--aov", "s"}, coarse), folder.path()).status, 0);
  const auto scene = nlohmann::json::parse(bytes_of(folder / "s/annotations.json"));
  EXPECT_EQ(scene.at("images").at(0).at("seed"), 5);
  EXPECT_EQ(scene.at("fruits").size(), 2u);
  EXPECT_EQ(scene.at("categories").size(), 1u);

  ASSERT_EQ(
      run_pomona(with({"grow", "cherry", "--seed", "3", "-o", "g.png", "--aov", "g"}, coarse), folder.path()).status,
      0);
  const auto whole = nlohmann::json::parse(bytes_of(folder / "g/annotations.json"));
  EXPECT_EQ(whole.at("images").at(0).at("seed"), 3);
  EXPECT_FALSE(whole.at("annotations").empty());
}

TEST(Aov, OfNoPictureIsAnErrorOfUsage) {
  const TemporaryFolder folder;
  const auto expect_refused = [&](const std::vector<std::string>& more, const char* why) {
    const Outcome outcome = cut_cherry(with(more, {"--aov", "truth"}), folder.path());
    EXPECT_EQ(outcome.status, 64);
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_FALSE(fs::exists(folder / "truth"));
  };
  expect_refused({"-o", "x.glb"}, "there is none");
  expect_refused({"-o", "x.png", "-o", "y.png"}, "there are several");
  expect_refused({"-o", "x.png", "--section"}, "leave out --section");
  const Outcome glass = run_pomona({"grow", "cherry", "--surfaces", "-o", "x.png", "--aov", "truth"}, folder.path());
  EXPECT_EQ(glass.status, 64);
  EXPECT_THAT(glass.err, HasSubstr("sees through"));
}

TEST(Aov, FoldersThatCannotBeAreToldFirst) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  const auto expect_refused = [&](const std::string& aov, const char* why) {
    const Outcome outcome = cut_cherry({"-o", "x.png", "--aov", aov}, folder.path());
    EXPECT_EQ(outcome.status, 73);
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_FALSE(fs::exists(folder / "x.png"));
  };
  expect_refused("file", "is a file, not a folder");
  expect_refused("no/such", "its folder does not exist");
  expect_refused("/proc/truth", "cannot be");
  EXPECT_EQ(bytes_of(folder / "file"), "not a folder");
}

TEST(Aov, DoesNotTakeThePlaceOfThePicture) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "truth");
  const Outcome outcome = cut_cherry({"-o", "truth/depth.png", "--aov", "truth"}, folder.path());
  EXPECT_EQ(outcome.status, 64);
  EXPECT_THAT(outcome.err, HasSubstr("two files of this run would be this one"));
  EXPECT_TRUE(fs::is_empty(folder / "truth"));
}

TEST(Aov, LeavesNoFolderBehindWhenThePictureCannotBe) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "x.png");
  const Outcome outcome = cut_cherry({"-o", "x.png", "--aov", "truth"}, folder.path());
  EXPECT_EQ(outcome.status, 74) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "truth"));
}

}  // namespace
}  // namespace pomona::testing
