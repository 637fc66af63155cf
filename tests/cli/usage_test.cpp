// What users mistype, and what the program answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/run_pomona.h"

namespace pomona::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct Mistake {
  const char* name;
  std::vector<std::string> words;
  int status;
  const char* says;
};

class Mistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, GetAClearErrorAndTheDocumentedStatus) {
  const TemporaryFolder folder;
  const Outcome outcome = run_pomona(GetParam().words, folder.path());
  EXPECT_EQ(outcome.status, GetParam().status) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("error:"));
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().says));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "something was written";
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, Mistakes,
    ::testing::Values(
        Mistake{"NoCommand", {}, 64, "subcommand"},
        Mistake{"UnknownCommand", {"gorw", "tomato", "-o", "x.ply"}, 64, "gorw"},
        Mistake{"MistypedOption", {"grow", "tomato", "--sede", "3", "-o", "x.ply"}, 64, "did you mean --seed"},
        Mistake{"NoOutput", {"grow", "tomato"}, 64, "--output"},
        Mistake{"UnknownEnding", {"grow", "tomato", "-o", "x.obj"}, 64, ".ply .glb .usda .pov .png"},
        Mistake{"SameOutputTwice", {"grow", "tomato", "-o", "x.ply", "-o", "./x.ply"}, 64, "twice"},
        Mistake{"NoLevels", {"grow", "tomato", "--lod", "0", "-o", "x.glb"}, 64, "--lod"},
        Mistake{"NineLevels", {"cut", "tomato", "--knife", "half", "--lod", "9", "-o", "x.glb"}, 64, "--lod"},
        Mistake{"LevelsInAPicture", {"grow", "tomato", "--lod", "2", "-o", "x.png"}, 64, "--lod is about .glb"},
        Mistake{"LevelsOfASection",
                {"cut", "tomato", "--knife", "half", "--section", "--lod", "2", "-o", "x.ply"},
                64,
                "--lod is about .glb"},
        Mistake{"LevelsForGodot",
                {"grow", "tomato", "--lod", "2", "--engine", "godot", "-o", "x.glb"},
                64,
                "Godot makes levels"},
        Mistake{
            "HullsInAPicture", {"grow", "tomato", "--engine", "unreal", "-o", "x.png"}, 64, "--engine is about .glb"},
        Mistake{"InstancesForUnreal",
                {"grow", "tomato", "--instances", "--engine", "unreal", "-o", "x.glb"},
                64,
                "EXT_mesh_gpu_instancing"},
        Mistake{"AnotherEngine", {"grow", "tomato", "--engine", "quake", "-o", "x.glb"}, 64, "--engine"},
        Mistake{"RipenessesWithoutTextures",
                {"grow", "tomato", "--ripeness-variants", "0,1", "-o", "x.glb"},
                64,
                "add --texture"},
        Mistake{"RipenessTwice",
                {"grow", "tomato", "--texture", "64", "--ripeness-variants", "1,1", "-o", "x.glb"},
                64,
                "no further ripeness"},
        Mistake{"NegativeIndex", {"grow", "tomato", "--index", "-1", "-o", "x.glb"}, 64, "--index"},
        Mistake{"NoSuchPiece",
                {"cut", "radish", "--knife", "half", "--piece", "3", "--detail", "0.2", "-o", "x.glb"},
                64,
                "fewer pieces"},
        Mistake{"SectionAsGlb", {"cut", "tomato", "--knife", "half", "--section", "-o", "x.glb"}, 64, ".ply .png"},
        Mistake{"UnknownTemplate", {"grow", "tomatoe", "-o", "x.ply"}, 66, "did you mean tomato"},
        Mistake{"MissingFile", {"grow", "no/such.toml", "-o", "x.ply"}, 66, "no such file"},
        Mistake{"MissingFolder", {"grow", "tomato", "-o", "nowhere/x.ply"}, 73, "folder"},
        Mistake{"UnknownKnife", {"cut", "tomato", "--knife", "haf", "-o", "x.ply"}, 64, "half"},
        Mistake{"KnifeWithoutNumber", {"cut", "tomato", "--knife", "wedges", "-o", "x.ply"}, 64, "wedges:"},
        Mistake{"PlaneOfThreeNumbers", {"cut", "tomato", "--knife", "plane:0,1,0", "-o", "x.ply"}, 64, "plane:"},
        Mistake{"PlaneWithoutDirection", {"cut", "tomato", "--knife", "plane:0,0,0,0", "-o", "x.ply"}, 64, "plane:"},
        Mistake{"SliceThinnerThanTheMeshResolves",
                {"cut", "radish", "--knife", "slices:0.001mm", "-o", "x.glb"},
                64,
                "hint: take slices of at least 0."},
        Mistake{"AMillionSlices", {"cut", "radish", "--knife", "slices:1000000", "-o", "x.glb"}, 64, "1024"},
        Mistake{"NoSlices", {"cut", "radish", "--knife", "slices:0", "-o", "x.glb"}, 64, "two pieces"},
        Mistake{"AMillionDice", {"cut", "radish", "--knife", "dice:100", "-o", "x.glb"}, 64, "hint: take larger"},
        Mistake{"TooManyCellsTogether",
                {"cut", "radish", "--knife", "slices:200", "--knife", "wedges:90", "-o", "x.glb"},
                64,
                "ten thousand"},
        Mistake{"PeelThickerThanAFruitWithAStem",
                {"cut", "tomato", "--knife", "peel:90mm", "-o", "x.glb"},
                64,
                "a peel of 90 mm is thicker than the fruit"},
        Mistake{"StrokeWithoutFile",
                {"cut", "radish", "--knife", "stroke:none.svg#a", "-o", "x.glb"},
                66,
                "none.svg: error: the stroke's file cannot be read"},
        Mistake{"SliceOfZero", {"cut", "tomato", "--knife", "slices:0mm", "-o", "x.ply"}, 64, "slices:"},
        Mistake{"RipenessOfAVolcano", {"grow", "volcano", "--ripeness", "0.5", "-o", "x.ply"}, 64, "ripens"},
        Mistake{"TooRipe", {"grow", "tomato", "--ripeness", "2.5", "-o", "x.ply"}, 64, "--ripeness"},
        Mistake{"BrowningOfAVolcano",
                {"cut", "volcano", "--knife", "half", "--browning", "1", "-o", "x.ply"},
                64,
                "turns brown"},
        Mistake{"FoldsOfAnOnion", {"grow", "onion", "--folds", "5", "-o", "x.ply"}, 64, "fold"},
        Mistake{"TooManyFolds", {"grow", "tomato", "--folds", "65", "-o", "x.ply"}, 64, "--folds"},
        Mistake{"VariationOutOfRange", {"grow", "tomato", "--variation", "3", "-o", "x.ply"}, 64, "--variation"},
        Mistake{"NegativeSeed", {"grow", "tomato", "--seed", "-1", "-o", "x.ply"}, 64, "--seed"},
        Mistake{"UnknownDiffuser",
                {"cut", "tomato", "--knife", "half", "--diffuser", "magic", "-o", "x.ply"},
                64,
                "--diffuser"},
        Mistake{"UnknownStyle", {"grow", "tomato", "--style", "oil", "-o", "x.png"}, 64, "ink"},
        Mistake{"SizeWithoutHeight", {"grow", "tomato", "--size", "800", "-o", "x.png"}, 64, "--size"},
        Mistake{"UnknownView", {"grow", "tomato", "--view", "sideways", "-o", "x.png"}, 64, "--view"},
        Mistake{"CompareWithNothing", {"compare", "x.png"}, 64, "RESULT"},
        Mistake{"ToleranceOutOfRange", {"compare", "x.png", "y.png", "--usual", "256"}, 64, "--usual"},
        Mistake{"MissingScene", {"scene", "salat.toml", "-o", "x.glb"}, 66, "no such file"},
        Mistake{"CheckMissingFile", {"check", "missing.toml"}, 66, "no such file"}),
    [](const auto& tested) { return tested.param.name; });

TEST(Help, IsPrintedByEveryCommand) {
  for (const char* command : {"list", "check", "sketch", "grow", "cut", "scene", "compare"}) {
    const Outcome outcome = run_pomona({command, "-h"});
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_THAT(outcome.out, HasSubstr(command));
    EXPECT_THAT(outcome.err, IsEmpty());
  }
}

TEST(Help, OfCutNamesEveryKnife) {
  const Outcome outcome = run_pomona({"cut", "-h"});
  for (const char* knife : {"half", "dice:12mm, dice:4", "stroke:FILE.svg#id", "ball:24mm", "peel:2mm", ",depth=4cm"}) {
    EXPECT_THAT(outcome.out, HasSubstr(knife));
  }
}

TEST(List, PrintsALineForEachTemplateFromAnyFolder) {
  const TemporaryFolder elsewhere;
  const Outcome outcome = run_pomona({"list"}, elsewhere.path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* line : {"tomato\t5-fold\t", "onion\tcylindrical\t", "pepper\t4-fold\t"}) {
    EXPECT_THAT(outcome.out, HasSubstr(line));
  }
}

TEST(Check, PassesEveryTemplateAndSceneOfTheTree) {
  std::vector<std::string> words = {"check"};
  for (const char* folder : {"templates", "scenes"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(POMONA_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".toml") words.push_back(entry.path().string());
    }
  }
  const Outcome outcome = run_pomona(words);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("warning"))) << "the shells of our own templates are closed";
}

}  // namespace
}  // namespace pomona::testing
