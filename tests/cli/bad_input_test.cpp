// Every malformed template, scene, batch and surface file of the tests, through the program: a clear error with a
// position, the documented status, nothing written, no crash.
#include <fstream>
#include <iterator>
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

/// A scene that can be read but not made, and its error.
struct ImpossibleScene {
  std::string text;
  int status = 0;
  std::string told;
};

const std::string cherries = "[[pieces]]\nname = \"cherry\"\ntemplate = \"cherry\"\nas_drawn = true\ndetail = 0.3\n";

std::vector<ImpossibleScene> impossible_scenes() {
  const std::string head = "format = 1\nname = \"impossible\"\n";
  const std::string dish = "[[dishes]]\nname = \"d\"\nmesh = \"line.obj\"\n";
  const std::string cup = "[bowl]\nprofile = \"M 0 0 L 15 0 L 20 -20 L 18 -20 L 13 -2 L 0 -2\"\n";
  return {{head + "settle.attempts = 1\n" + cup + cherries + "total = 40\n", 1,
           "scene.toml:7:8: error: the pieces do not settle: piece \"cherry-1[^\"]*\" (finds no room in|lies outside) "
           "the bowl"},
          {head + "[bowl]\nprofile = \"M 0 0 L 60 0 L 60 -5 L 0 -5\"\n" + cherries, 65,
           "scene.toml:6:8: error: \"bowl\" has no hollow"},
          {head + dish + cherries + "on = \"d\"\nwhere = { kind = \"scatter\" }\n", 65,
           "scene.toml:5:8: error: dish \"d\": .*no area"},
          {head + "layout = \"other.json\"\n" + cherries + "total = 2\n", 65, "other.json:3:[0-9]+: error: \"guest\""}};
}

TEST(BadInput, OfScenesThatCannotBeIsNamedAndLeavesWhatWasThere) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "line.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
  const auto line = [](const std::string& name) {
    return "{\"name\": \"" + name +
           "\", \"solid\": \"cherry-1\", \"rotation\": [1, 0, 0, 0], \"translation\": [0, 0, 0]}";
  };
  std::ofstream(folder.path() / "other.json") << "{\"format\": 1, \"instances\": [\n"
                                              << line("cherry-1") << ", " << line("cherry-1.copy-2") << ",\n"
                                              << line("guest") << "]}\n";
  std::ofstream(folder.path() / "x.glb") << "as it was";
  for (const ImpossibleScene& scene : impossible_scenes()) {
    std::ofstream(folder.path() / "scene.toml") << scene.text;
    const Outcome outcome = run_pomona({"scene", "scene.toml", "--quality", "draft", "-o", "x.glb", "-o", "x.json",
                                        "-o", "x.png", "--size", "64x48", "--aov", "truth"},
                                       folder.path());
    EXPECT_EQ(outcome.status, scene.status) << outcome.err;
    EXPECT_TRUE(std::regex_search(outcome.err, std::regex(scene.told))) << outcome.err;
    EXPECT_EQ(bytes_of(folder.path() / "x.glb"), "as it was");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 4) << outcome.err;
  }
}

/// A box of 1 m with 4913 boxes in it that face inwards: walls of cavities.
std::string box_of_cavities() {
  std::string vertices, faces;
  int first = 1;
  const auto add_box = [&](double x, double y, double z, double size, bool inwards) {
    for (int corner = 0; corner < 8; ++corner) {
      vertices += "v " + std::to_string(x + size * (corner & 1)) + " " + std::to_string(y + size * (corner >> 1 & 1)) +
                  " " + std::to_string(z + size * (corner >> 2)) + "\n";
    }
    const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& side : sides) {
      faces += "f";
      for (int i = 0; i < 4; ++i) faces += " " + std::to_string(first + side[inwards ? 3 - i : i]);
      faces += "\n";
    }
    first += 8;
  };
  add_box(0, 0, 0, 1, false);
  for (int i = 0; i < 17 * 17 * 17; ++i)
    add_box(0.05 * (i % 17) + 0.05, 0.05 * (i / 17 % 17) + 0.05, 0.05 * (i / 289) + 0.05, 0.02, true);
  return vertices + faces;
}

TEST(BadInput, ThousandsOfCavitiesAreNone) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "sponge.obj") << box_of_cavities();
  std::ofstream(folder.path() / "sponge.toml")
      << "format = 1\nname = \"sponge\"\nparts = [\"skin\", \"flesh\"]\n[symmetry]\nkind = \"none\"\n"
         "[[mesh]]\nname = \"skin\"\nfile = \"sponge.obj\"\nback = { part = \"flesh\", color = \"#d9a03c\" }\n"
         "front = { part = \"skin\", hidden = true, color = \"#5b2a55\" }\n";
  EXPECT_EQ(run_pomona({"check", "sponge.toml"}, folder.path()).status, 0);
  const Outcome cut = run_pomona({"cut", "sponge.toml", "--knife", "half", "--json", "-o", "x.ply"}, folder.path());
  EXPECT_EQ(cut.status, 0) << cut.err;
}

}  // namespace
}  // namespace pomona::testing
