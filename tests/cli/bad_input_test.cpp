// Every malformed template, scene, batch and surface file of the tests, through the program: a clear error with a
// position, the documented status, nothing written, no crash.
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/run_pomona.h"

namespace fs = std::filesystem;

namespace pomona::testing {
namespace {

std::vector<fs::path> bad_files() {
  std::vector<fs::path> files;
  for (const char* folder : {"template", "scene", "batch", "surface"}) {
    const fs::path bad = fs::path(POMONA_SOURCE_DIR) / "tests" / folder / "bad";
    for (const auto& entry : fs::directory_iterator(bad)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".toml" || extension == ".ply") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(BadInput, HasAtLeastFortyFiles) { EXPECT_GE(bad_files().size(), 40u); }

TEST(BadInput, GetsAPositionAndStatus65) {
  const std::regex positioned(":([0-9]+:[0-9]+|[a-z_ ]+[0-9]*(, byte [0-9]+)?): error: .{8,}");
  for (const fs::path& file : bad_files()) {
    const Outcome outcome = run_pomona({"check", file.string()});
    EXPECT_EQ(outcome.status, 65) << file << "\n" << outcome.err;
    EXPECT_TRUE(std::regex_search(outcome.err, positioned)) << file << "\n" << outcome.err;
  }
}

TEST(BadInput, LeavesNoFileBehind) {
  const TemporaryFolder folder;
  for (const fs::path& file : bad_files()) {
    if (file.parent_path().parent_path().filename() == "scene") {
      run_pomona({"scene", file.string(), "-o", "x.glb", "-o", "x.json"}, folder.path());
    } else {
      run_pomona({"cut", file.string(), "--knife", "half", "-o", "x.ply"}, folder.path());
    }
    EXPECT_TRUE(fs::is_empty(folder.path())) << file;
  }
}

}  // namespace
}  // namespace pomona::testing
