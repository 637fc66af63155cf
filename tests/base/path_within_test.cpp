#include "generator/base/path_within.h"
#include "generator/base/beside.h"
#include "tests/base/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace pomona {
namespace {

namespace fs = std::filesystem;

/// A folder "inner" with a file and links, beside a file that is not in it.
class PathWithin : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(inner() / "deep");
    std::ofstream(outer_ / "secret") << "x";
    std::ofstream(inner() / "here") << "x";
    fs::create_symlink(outer_ / "secret", inner() / "link-out");
    fs::create_symlink("here", inner() / "link-in");
  }
  fs::path inner() const { return outer_ / "inner"; }

  const TemporaryFolder folder_;
  const fs::path outer_ = folder_.path();
};

TEST_F(PathWithin, leads_to_what_lies_in_the_folder_or_below) {
  EXPECT_EQ(path_within(inner(), inner() / "here"), fs::path("here"));
  EXPECT_EQ(path_within(inner(), inner() / "deep/new"), fs::path("deep/new"));
  EXPECT_EQ(path_within(inner(), inner() / "deep/../here"), fs::path("here"));
  EXPECT_EQ(path_within(inner(), inner() / "link-in"), fs::path("here"));
  EXPECT_EQ(path_within(inner(), inner() / "no such file"), fs::path("no such file"));
}

TEST_F(PathWithin, leads_nowhere_else) {
  EXPECT_FALSE(path_within(inner(), inner() / "../secret"));
  EXPECT_FALSE(path_within(inner(), inner() / "no/../../secret"));
  EXPECT_FALSE(path_within(inner(), inner() / "link-out"));
  EXPECT_FALSE(path_within(inner(), "/etc/passwd"));
}

TEST_F(PathWithin, no_folder_is_the_current_one) {
  EXPECT_EQ(path_within("", "no such file"), fs::path("no such file"));
  EXPECT_FALSE(path_within("", "../no such file"));
}

TEST_F(PathWithin, words_of_commands_lead_from_the_folder_of_a_file) {
  const fs::path here = fs::current_path();
  fs::current_path(outer_);
  EXPECT_EQ(word_from("inner", "looks/a.toml"), "../looks/a.toml");
  EXPECT_EQ(word_from("inner/deep", "./inner/here"), "../here");
  EXPECT_EQ(word_from(inner() / "deep", "photos/"), "../../photos");
  EXPECT_EQ(word_from("inner", "inner/link-out"), "link-out") << "a link stays what it is called";
  EXPECT_EQ(word_from("inner", "."), "..");
  EXPECT_EQ(word_from("", "./photos/"), "photos");
  for (const char* folder : {"", "inner"}) EXPECT_EQ(word_from(folder, "/home/me/photos/"), "photos");
  fs::current_path(here);
}

TEST_F(PathWithin, files_are_found_beside_those_that_name_them) {
  EXPECT_EQ(found_beside(inner() / "set.toml", "here"), inner() / "here");
  EXPECT_FALSE(found_beside(inner() / "set.toml", "deep"));
  EXPECT_EQ(style_beside("sets/a.toml", "own/b.toml"), "sets/own/b.toml");
  EXPECT_EQ(style_beside("sets/a.toml", "OWN.TOML"), "sets/OWN.TOML");
  EXPECT_EQ(style_beside("sets/a.toml", "own/b"), "sets/own/b");
  EXPECT_EQ(style_beside("sets/a.toml", "ink"), "ink");
}

}  // namespace
}  // namespace pomona
