// From template to file by the program: same seed, same bytes; files and program agree.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_pomona.h"

namespace pomona::testing {
namespace {

using ::testing::HasSubstr;

// Coarse fruit: the tested properties do not depend on the tessellation.
const std::vector<std::string> coarse = {"--detail", "0.4", "--quality", "draft", "--quiet"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void expect_done(const Outcome& outcome) { ASSERT_EQ(outcome.status, 0) << outcome.err; }

class Fruit : public ::testing::TestWithParam<const char*> {};

TEST_P(Fruit, GivesTheSameBytesWithOneAndTwoThreads) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2"}) {
    const std::string stem = std::string("x") + threads;
    expect_done(run_pomona(with({"cut", GetParam(), "--knife", "wedges:3", "--seed", "7", "--threads", threads, "-o",
                                 stem + ".glb", "-o", stem + ".ply"},
                                coarse),
                           folder.path()));
    expect_done(run_pomona(with({"cut", GetParam(), "--knife", "half", "--seed", "7", "--threads", threads, "--section",
                                 "--size", "200x200", "-o", stem + ".png"},
                                coarse),
                           folder.path()));
  }
  for (const char* ending : {".glb", ".ply", ".png"}) {
    EXPECT_FALSE(bytes_of(folder / (std::string("x1") + ending)).empty());
    EXPECT_EQ(bytes_of(folder / (std::string("x1") + ending)), bytes_of(folder / (std::string("x2") + ending)))
        << ending;
  }
}

TEST_P(Fruit, LevelsOfDetailDoNotDependOnThreadsAndAreCounted) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2"}) {
    const std::string stem = std::string("x") + threads;
    expect_done(run_pomona(with({"cut", GetParam(), "--knife", "half", "--threads", threads, "--lod", "2", "-o",
                                 stem + ".glb", "--stats", stem + ".json"},
                                coarse),
                           folder.path()));
  }
  EXPECT_EQ(bytes_of(folder / "x1.glb"), bytes_of(folder / "x2.glb"));
  EXPECT_THAT(bytes_of(folder / "x1.glb"), HasSubstr("_LOD2"));
  const auto counts = nlohmann::json::parse(bytes_of(folder / "x1.json")).at("counts");
  EXPECT_LT(counts.at("lod_1_triangles").get<int>(), counts.at("lod_0_triangles").get<int>());
  EXPECT_LT(counts.at("lod_2_triangles").get<int>(), counts.at("lod_1_triangles").get<int>());
}

TEST_P(Fruit, SeedsDifferAndShareTheirConnectivity) {
  const TemporaryFolder folder;
  // Numbers of folds and layers vary, too, unless they are fixed.
  const std::vector<std::string> fixed =
      std::string(GetParam()) == "pepper" ? std::vector<std::string>{"--folds", "4"} : std::vector<std::string>{};
  for (const char* seed : {"0", "1", "2"}) {
    std::vector<std::string> words{"grow", GetParam(), "--seed", seed, "-o", std::string(seed) + ".ply"};
    words.insert(words.end(), fixed.begin(), fixed.end());
    expect_done(run_pomona(with(words, coarse), folder.path()));
  }
  const std::string drawn = bytes_of(folder / "0.ply"), one = bytes_of(folder / "1.ply"),
                    two = bytes_of(folder / "2.ply");
  EXPECT_NE(drawn, one);
  EXPECT_NE(one, two);
  // The faces follow the vertices, and the header has their number: equal tails mean equal faces.
  const std::size_t header = drawn.find("end_header\n") + 11;
  const std::size_t vertices = std::stoul(drawn.substr(drawn.find("element vertex ") + 15));
  constexpr std::size_t vertex_bytes = 3 * 4 + 3 + 6 * 4 + 4 + 2;
  const std::size_t faces_at = header + vertices * vertex_bytes;
  ASSERT_LT(faces_at, drawn.size());
  EXPECT_EQ(drawn.substr(faces_at), one.substr(faces_at));
  EXPECT_EQ(drawn.substr(faces_at), two.substr(faces_at));
}

TEST_P(Fruit, CutFromItsSurfaceFileGivesTheSameSection) {
  const TemporaryFolder folder;
  expect_done(
      run_pomona(with({"grow", GetParam(), "--seed", "3", "--sheets", "-o", "sheets.ply"}, coarse), folder.path()));
  expect_done(
      run_pomona(with({"cut", GetParam(), "--seed", "3", "--knife", "across", "--section", "-o", "a.ply"}, coarse),
                 folder.path()));
  expect_done(run_pomona(
      {"cut", "sheets.ply", "--knife", "across", "--section", "-o", "b.ply", "--quality", "draft", "--quiet"},
      folder.path()));
  EXPECT_FALSE(bytes_of(folder / "a.ply").empty());
  EXPECT_EQ(bytes_of(folder / "a.ply"), bytes_of(folder / "b.ply"));
}

TEST_P(Fruit, StatsNameEveryStageOfTheRoad) {
  const TemporaryFolder folder;
  expect_done(run_pomona(with({"cut", GetParam(), "--knife", "half", "--stats", "stats.json", "-o", "x.glb"}, coarse),
                         folder.path()));
  const auto stats = nlohmann::json::parse(bytes_of(folder / "stats.json"));
  for (const char* stage : {"read", "vary", "sweep", "cut", "diffuse", "style", "write"}) {
    EXPECT_TRUE(stats.at("stages").contains(stage)) << stage;
  }
  for (const char* count : {"surface_triangles", "interior_vertices", "section_triangles", "pieces"}) {
    EXPECT_GT(stats.at("counts").at(count), 0) << count;
  }
  EXPECT_EQ(stats.at("diffuser"), "cpu");
  EXPECT_EQ(stats.at("device"), "cpu");
}

TEST(Ripeness, AtOneGivesTheBytesOfTheDrawing) {
  const TemporaryFolder folder;
  const std::vector<std::string> cut = {"cut", "apple", "--knife", "half", "--section"};
  expect_done(run_pomona(with(with(cut, {"-o", "drawn.ply"}), coarse), folder.path()));
  expect_done(run_pomona(with(with(cut, {"--ripeness", "1", "-o", "one.ply"}), coarse), folder.path()));
  expect_done(run_pomona(with(with(cut, {"--ripeness", "0.4", "-o", "green.ply"}), coarse), folder.path()));
  EXPECT_EQ(bytes_of(folder / "drawn.ply"), bytes_of(folder / "one.ply"));
  EXPECT_NE(bytes_of(folder / "drawn.ply"), bytes_of(folder / "green.ply"));

  // The surfaces have the ripened colours, so their file gives the same section.
  expect_done(
      run_pomona(with({"grow", "apple", "--ripeness", "0.4", "--sheets", "-o", "sheets.ply"}, coarse), folder.path()));
  expect_done(run_pomona(with({"cut", "sheets.ply", "--knife", "half", "--section", "-o", "again.ply"}, coarse),
                         folder.path()));
  EXPECT_EQ(bytes_of(folder / "green.ply"), bytes_of(folder / "again.ply"));
}

TEST(Browning, IsInPicturesAndPiecesButNotInTheFileOfASection) {
  const TemporaryFolder folder;
  for (const char* time : {"0", "0.8"}) {
    const std::string stem = std::string("x") + time;
    const std::vector<std::string> cut = {"cut", "apple", "--knife", "half", "--browning", time};
    expect_done(run_pomona(
        with(with(cut, {"--section", "--size", "100x100", "-o", stem + ".ply", "-o", stem + ".png"}), coarse),
        folder.path()));
    expect_done(run_pomona(with(with(cut, {"-o", stem + ".glb"}), coarse), folder.path()));
  }
  EXPECT_EQ(bytes_of(folder / "x0.ply"), bytes_of(folder / "x0.8.ply"));
  EXPECT_NE(bytes_of(folder / "x0.png"), bytes_of(folder / "x0.8.png"));
  EXPECT_NE(bytes_of(folder / "x0.glb"), bytes_of(folder / "x0.8.glb"));
}

TEST(Lines, AreTheSameForAnyNumberOfThreadsAndGoneWithoutInk) {
  const TemporaryFolder folder;
  const std::vector<std::string> cut = {"cut", "tomato", "--knife", "half", "--size", "160x120"};
  for (const char* threads : {"1", "2"}) {
    const std::string end = std::string(threads) + ".svg";
    const std::vector<std::string> words = with(cut, {"--threads", threads});
    expect_done(run_pomona(with(with(words, {"--section", "-o", "section" + end}), coarse), folder.path()));
    expect_done(run_pomona(with(with(words, {"-o", "pieces" + end}), coarse), folder.path()));
  }
  for (const std::string what : {"section", "pieces"}) {
    const std::string drawing = bytes_of(folder / (what + "1.svg"));
    EXPECT_EQ(drawing, bytes_of(folder / (what + "2.svg"))) << what;
    EXPECT_THAT(drawing, HasSubstr("<path"));
    EXPECT_THAT(drawing, HasSubstr(what == "section" ? "inkscape:label=\"gel\"" : "inkscape:label=\"tomato.piece-2\""));
  }
  expect_done(run_pomona(with(with(cut, {"--style", "plain", "-o", "plain.svg"}), coarse), folder.path()));
  EXPECT_THAT(bytes_of(folder / "plain.svg"), ::testing::Not(HasSubstr("<path")));
}

TEST(Plate, IsDrawnInAnyStyleAndAnySize) {
  const TemporaryFolder folder;
  for (const std::string style : {"plate", "stipple"}) {
    expect_done(run_pomona({"plate", "cherry", "--style", style, "--size", "240x300", "--quality", "draft", "--detail",
                            "0.3", "-o", style + ".png"},
                           folder.path()));
    EXPECT_EQ(bytes_of(folder / (style + ".png")).substr(16, 8), std::string("\0\0\0\xf0\0\0\x01\x2c", 8));
  }
  EXPECT_NE(bytes_of(folder / "plate.png"), bytes_of(folder / "stipple.png"));
}

/// PNG's pHYs: pixels per metre in x and y, and the unit.
TEST(Paper, HasTheSizeThatPicturesAndDrawingsSay) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"cut",    "tomato",  "--knife", "half", "--section",
                                          "--size", "30x20mm", "--dpi",   "254"};
  expect_done(run_pomona(with(with(words, {"-o", "x.png", "-o", "x.svg"}), coarse), folder.path()));
  const std::string png = bytes_of(folder / "x.png");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x01\x2c\0\0\0\xc8", 8));
  EXPECT_THAT(png, HasSubstr(std::string("pHYs\0\0\x27\x10\0\0\x27\x10\x01", 13)));
  EXPECT_THAT(bytes_of(folder / "x.svg"), HasSubstr("width=\"30mm\" height=\"20mm\" viewBox=\"0 0 300 200\""));

  // Without --dpi there is no pHYs, and pixels are the unit.
  expect_done(run_pomona(
      with({"cut", "tomato", "--knife", "half", "--section", "--size", "30x20", "-o", "y.png", "-o", "y.svg"}, coarse),
      folder.path()));
  EXPECT_THAT(bytes_of(folder / "y.png"), ::testing::Not(HasSubstr("pHYs")));
  EXPECT_THAT(bytes_of(folder / "y.svg"), HasSubstr("width=\"30\" height=\"20\""));
}

TEST(Lines, OfSectionsHoldNoPictureButOfThePaper) {
  const TemporaryFolder folder;
  for (const std::string style : {"ink", "plain", "hatching", "stipple"}) {
    expect_done(run_pomona(
        with({"cut", "tomato", "--knife", "half", "--section", "--size", "160x120", "--style", style, "-o", "x.svg"},
             coarse),
        folder.path()));
    const std::string drawing = bytes_of(folder / "x.svg");
    const std::size_t picture = drawing.find("<image");
    EXPECT_EQ(picture == std::string::npos, style == "plain" || style == "stipple") << style;
    if (picture != std::string::npos) {
      EXPECT_LT(drawing.find("id=\"paper\""), picture) << style;
      EXPECT_GT(drawing.find("<g", drawing.find("id=\"paper\"")), picture) << style;
      EXPECT_EQ(drawing.find("<image", picture + 1), std::string::npos) << style;
    }
    EXPECT_THAT(drawing, HasSubstr(style == "stipple" ? "<circle" : "<path")) << style;
    EXPECT_EQ(drawing.find("label=\"marks\"") != std::string::npos, style == "hatching" || style == "stipple") << style;
  }
}

TEST(Lines, OfSolidsHoldTheMarksOfTheirStyle) {
  const TemporaryFolder folder;
  for (const std::string style : {"hatching", "stipple"}) {
    expect_done(run_pomona(
        with({"cut", "tomato", "--knife", "half", "--size", "160x120", "--style", style, "-o", "x.svg"}, coarse),
        folder.path()));
    const std::string drawing = bytes_of(folder / "x.svg");
    const std::size_t marks = drawing.find("label=\"marks\""), lines = drawing.find("label=\"tomato.piece-1\"");
    ASSERT_NE(marks, std::string::npos) << style;
    EXPECT_LT(marks, lines) << style << ": strokes lie above";
    EXPECT_GT(drawing.find(style == "stipple" ? "<circle" : "<path", marks), marks) << style;
    EXPECT_THAT(drawing, ::testing::Not(HasSubstr("<image"))) << style;
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, Fruit, ::testing::Values("tomato", "onion", "pepper"),
                         [](const auto& tested) { return std::string(tested.param); });

nlohmann::json pieces_of(const std::string& fruit, const std::string& knife, const std::string& threads) {
  const TemporaryFolder folder;
  expect_done(run_pomona(
      with({"cut", fruit, "--knife", knife, "--threads", threads, "--pieces", "x.json", "-o", "x.ply"}, coarse),
      folder.path()));
  return nlohmann::json::parse(bytes_of(folder / "x.json"))["pieces"];
}

double volume_of(const nlohmann::json& pieces) {
  double sum = 0;
  for (const nlohmann::json& piece : pieces) sum += piece["volume"].get<double>();
  return sum;
}

class Peel : public ::testing::TestWithParam<const char*> {};

/// Whole or in a strip, a peel is one piece and the rest another; both are closed and add up.
TEST_P(Peel, ComesOffInOnePiece) {
  const double whole = volume_of(pieces_of(GetParam(), "half", "2"));
  const std::string peel = "peel:1.5mm", strip = "peel:1.5mm,spiral=12mm";
  for (const std::string& knife : {peel, strip}) {
    const nlohmann::json pieces = pieces_of(GetParam(), knife, "2");
    if (knife == strip) {
      EXPECT_EQ(pieces, pieces_of(GetParam(), knife, "1"));
    }
    int large = 0;
    for (const nlohmann::json& piece : pieces) {
      EXPECT_TRUE(piece["closed"].get<bool>()) << knife;
      large += piece["crumb"].get<bool>() ? 0 : 1;
    }
    EXPECT_EQ(large, 2) << knife;
    EXPECT_NEAR(volume_of(pieces) / whole, 1, 1e-5) << knife;
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, Peel, ::testing::Values("apple", "lemon", "tomato"),
                         [](const auto& entry) { return std::string(entry.param); });

TEST(Cut, AKnifeThatMissesIsAWarning) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_pomona({"cut", "tomato", "--knife", "plane:0,1,0,5", "--detail", "0.4", "-o", "x.glb"}, folder.path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("warning"));
  EXPECT_FALSE(bytes_of(folder / "x.glb").empty());
}

TEST(Cut, LeavesExistingOutputsAloneWhenItFails) {
  const TemporaryFolder folder;
  expect_done(run_pomona(with({"cut", "tomato", "--knife", "half", "-o", "x.ply"}, coarse), folder.path()));
  const std::string before = bytes_of(folder / "x.ply");
  EXPECT_NE(run_pomona({"cut", "tomato", "--knife", "nonsense", "-o", "x.ply"}, folder.path()).status, 0);
  EXPECT_EQ(bytes_of(folder / "x.ply"), before);
}

TEST(Grow, OtherFoldsGiveOtherFruit) {
  const TemporaryFolder folder;
  for (const char* folds : {"3", "5", "7"}) {
    expect_done(run_pomona(with({"grow", "tomato", "--folds", folds, "-o", std::string(folds) + ".ply"}, coarse),
                           folder.path()));
  }
  EXPECT_EQ(run_pomona(with({"grow", "tomato", "-o", "drawn.ply"}, coarse), folder.path()).status, 0);
  EXPECT_EQ(bytes_of(folder / "5.ply"), bytes_of(folder / "drawn.ply")) << "the drawn folds, repeated in turn";
  EXPECT_NE(bytes_of(folder / "3.ply"), bytes_of(folder / "7.ply"));
}

/// The JSON of a .glb: its first chunk.
nlohmann::json json_of_glb(const std::string& glb) {
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= static_cast<std::uint32_t>(static_cast<unsigned char>(glb.at(12 + i))) << 8 * i;
  return nlohmann::json::parse(glb.substr(20, length));
}

TEST(Maps, AreCountedByTheirFolderAndOtherFilesNamed) {
  const TemporaryFolder folder;
  const Outcome outcome = run_pomona({"cut", "cherry", "--knife", "half", "--detail", "0.4", "--quality", "draft",
                                      "--texture", "64", "--maps-dir", "maps/", "-o", "x.glb"},
                                     folder.path());
  expect_done(outcome);
  const auto files = std::distance(std::filesystem::directory_iterator(folder / "maps"), {});
  EXPECT_GT(files, 4);
  EXPECT_THAT(outcome.err, HasSubstr("wrote x.glb"));
  EXPECT_THAT(outcome.err, HasSubstr("wrote " + std::to_string(files) + " files in maps ("));
  EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr(".png")));
}

TEST(Pieces, WeighTheSameInTheListAndInTheGlb) {
  const TemporaryFolder folder;
  expect_done(run_pomona(with({"cut", "cherry", "--knife", "half", "-o", "x.glb", "--pieces", "x.json"}, coarse),
                         folder.path()));
  const auto list = nlohmann::json::parse(bytes_of(folder / "x.json")).at("pieces");
  const nlohmann::json glb = json_of_glb(bytes_of(folder / "x.glb"));
  ASSERT_EQ(list.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const nlohmann::json &piece = list[i], &extras = glb.at("meshes").at(i).at("extras");
    for (const char* key : {"volume", "density", "mass", "center", "inertia"})
      EXPECT_EQ(piece.at(key), extras.at(key)) << key;

    // No axis has more inertia than the sum of the other two.
    EXPECT_NEAR(piece.at("mass").get<double>(), piece.at("density").get<double>() * piece.at("volume").get<double>(),
                1e-12);
    const auto& inertia = piece.at("inertia");
    const double x = inertia[0][0], y = inertia[1][1], z = inertia[2][2];
    EXPECT_TRUE(x > 0 && y > 0 && z > 0 && x < y + z && y < z + x && z < x + y);
    EXPECT_NEAR(inertia[0][1].get<double>(), inertia[1][0].get<double>(), 1e-9 * x);
  }

  // The stone stays whole in one half and makes it denser than the flesh; the other half has only flesh and skin.
  const double one = list[0].at("density"), other = list[1].at("density");
  EXPECT_GT(std::max(one, other), 1046);
  EXPECT_LT(std::min(one, other), 1041);
}

/// More variants than are made at once, a dish, and pieces that are placed more than once.
const char* const small_scene =
    "format = 1\nname = \"small\"\nseed = 3\n"
    "[bowl]\nprofile = \"M 0 0 L 60 0 L 110 -50 L 106 -50 L 58 -4 L 0 -4\"\n"
    "[[pieces]]\nname = \"halves\"\ntemplate = \"cherry\"\nknives = [\"half\"]\ncount = 20\ntotal = 30\n"
    "[[pieces]]\nname = \"slices\"\ntemplate = \"radish\"\nknives = [\"slices:9mm\"]\ntake = 2\n";

/// A single .glb is written while the scene is made. Together with a file that needs the whole scene it is written
/// last.
TEST(Scenes, WrittenOnTheirWayAreTheSameBytesForAnyThreads) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--lod", "2", "--engine", "unity"}, {"--texture", "64", "--maps", "all"}}) {
    const TemporaryFolder folder;
    std::ofstream(folder / "small.toml") << small_scene;
    std::ofstream(folder / "laid.toml") << "layout = \"whole.json\"\n" << small_scene;  // settles once, to save time
    const auto make = [&](const std::string& scene, const std::vector<std::string>& words) {
      const std::vector<std::string> how = {"scene", scene, "--detail", "0.1", "--quality", "draft", "--quiet"};
      expect_done(run_pomona(with(with(how, words), options), folder.path()));
    };
    make("small.toml", {"-o", "whole.glb", "-o", "whole.obj", "-o", "whole.json"});
    make("small.toml", {"--threads", "1", "-o", "one.glb", "-o", "one.json"});
    make("laid.toml", {"--threads", "5", "-o", "five.glb"});
    std::vector<std::string> written = {"one.glb", "five.glb"};
    if (options.empty()) {
      make("laid.toml", {"--threads", "2", "-o", "two.glb", "-o", "three.glb"});
      written.insert(written.end(), {"two.glb", "three.glb"});
    }
    const std::string whole = bytes_of(folder / "whole.glb");
    ASSERT_GT(whole.size(), 10000u);
    for (const std::string& file : written)
      EXPECT_TRUE(bytes_of(folder / file) == whole) << file << " " << ::testing::PrintToString(options);
    EXPECT_EQ(bytes_of(folder / "one.json"), bytes_of(folder / "whole.json"));
  }
}

/// A scene that is refused leaves no incomplete output, and an existing file stays.
TEST(Scenes, RefusedOnTheirWayLeaveNothingBehind) {
  const TemporaryFolder folder;
  std::ofstream(folder / "full.toml")
      << "format = 1\nname = \"full\"\nsettle.attempts = 1\n"
         "[bowl]\nprofile = \"M 0 0 L 20 0 L 30 -10 L 28 -10 L 18 -2 L 0 -2\"\n"
         "[[pieces]]\nname = \"halves\"\ntemplate = \"cherry\"\nknives = [\"half\"]\ntotal = 40\n";
  std::ofstream(folder / "full.glb") << "as it was";
  const Outcome outcome =
      run_pomona(with({"scene", "full.toml", "-o", "full.glb", "-o", "full.json"}, coarse), folder.path());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("full.toml:7:8: error: "));
  EXPECT_EQ(bytes_of(folder / "full.glb"), "as it was");
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

/// Levels and textures are made once for all files, in any order of outputs.
TEST(Scenes, AreBakedOnceForAllTheirFiles) {
  const TemporaryFolder folder;
  std::ofstream(folder / "small.toml") << std::regex_replace(small_scene, std::regex("count = 20\ntotal = 30"), "");
  const std::vector<std::string> how =
      with({"scene", "small.toml", "--texture", "64", "--maps", "all", "--lod", "1"}, coarse);
  const auto texels = [&](const std::string& stats) {
    return nlohmann::json::parse(bytes_of(folder / stats)).at("counts").at("texels").get<int>();
  };
  expect_done(run_pomona(with(how, {"-o", "one.glb", "--stats", "glb.json"}), folder.path()));
  expect_done(run_pomona(with(how, {"-o", "one.usda"}), folder.path()));
  std::filesystem::rename(folder / "one.usda", folder / "alone.usda");
  expect_done(run_pomona(with(how, {"-o", "one.usda", "-o", "both.glb", "--stats", "both.json"}), folder.path()));
  EXPECT_GT(texels("glb.json"), 0);
  EXPECT_EQ(texels("both.json"), texels("glb.json"));
  EXPECT_TRUE(bytes_of(folder / "both.glb") == bytes_of(folder / "one.glb"));
  EXPECT_TRUE(bytes_of(folder / "one.usda") == bytes_of(folder / "alone.usda"));
}

}  // namespace
}  // namespace pomona::testing
