// Wrong command lines and the program's answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

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
        Mistake{"OptionBeforeTheCommand",
                {"--quiet", "cut", "kiwi", "--knife", "half", "-o", "x.glb"},
                64,
                "it belongs behind it: `pomona cut ... --quiet`"},
        Mistake{"KnifeInCapitals", {"cut", "kiwi", "--knife", "HALF", "-o", "x.glb"}, 64, "did you mean \"half\"?"},
        Mistake{"HelpOfNoCommand", {"help", "bogus"}, 64, "there is no command"},
        Mistake{"SeedTwice", {"grow", "kiwi", "--seed", "1", "--seed", "2", "-o", "x.glb"}, 64, "more than once"},
        Mistake{"SeedsOfNothing", {"grow", "kiwi", "--seeds", "", "-o", "x.glb"}, 64, "says nothing"},
        Mistake{"ThicknessOfNothing", {"cut", "kiwi", "--knife", "crinkle:0mm", "-o", "x.glb"}, 64, "such as 6mm"},
        Mistake{"BatchOfNoName", {"batch", "nothere", "-o", "x"}, 66, "there is no batch"},
        Mistake{"TemplateAsStyle",
                {"grow", "kiwi", "--style", POMONA_SOURCE_DIR "/templates/kiwi.toml", "-o", "x.png"},
                65,
                "is a template"},
        Mistake{"CheckOfWhatIsNotRead", {"check", POMONA_SOURCE_DIR "/README.md"}, 65, "no ending of a file"},
        Mistake{"PovOfTwoLines", {"grow", "kiwi", "-o", "two\nlines.pov"}, 64, "control character"},
        Mistake{"PlateOfNoPicture", {"plate", "kiwi", "-o", "x.glb"}, 64, "it writes .png"},
        Mistake{"PlateWithoutAKnife", {"plate", "kiwi", "--section", "acros", "-o", "x.png"}, 64, "across"},
        Mistake{"PlateWithTruth", {"plate", "kiwi", "--aov", "truth", "-o", "x.png"}, 64, "--aov"},
        Mistake{"SeedsBackwards", {"grow", "kiwi", "--seeds", "5-1", "-o", "x.glb"}, 64, "write --seeds 1-5"},
        Mistake{"TooManySeeds", {"grow", "kiwi", "--seeds", "1-1000000000000", "-o", "x.glb"}, 64, "up to 64 seeds"},
        Mistake{"SeedsOfWords", {"grow", "kiwi", "--seeds", "1,two", "-o", "x.glb"}, 64, "write --seeds 1-5"},
        Mistake{"NoSeeds", {"grow", "kiwi", "--seeds", "1,", "-o", "x.glb"}, 64, "write --seeds 1-5"},
        Mistake{"SeedsAndASeed", {"grow", "kiwi", "--seeds", "1-2", "--seed", "1", "-o", "x.glb"}, 64, "--seed"},
        Mistake{"SeedsOfSurfaces", {"grow", "kiwi", "--seeds", "1-2", "-o", "x.ply"}, 64, "holds one fruit alone"},
        Mistake{"SeedsOfASection",
                {"cut", "kiwi", "--knife", "half", "--seeds", "1-2", "--section", "-o", "x.png"},
                64,
                "--seeds does not go with --section"},
        Mistake{"PaperWithoutDpi",
                {"cut", "kiwi", "--knife", "half", "--section", "--size", "120x90mm", "-o", "x.png"},
                64,
                "--dpi 300"},
        Mistake{"PaperTooLarge",
                {"cut", "kiwi", "--knife", "half", "--section", "--size", "9x9in", "--dpi", "2400", "-o", "x.png"},
                64,
                "16 to 16384 pixels a side"},
        Mistake{"NoCommand", {}, 64, "hint: pomona needs one of list, check,"},
        Mistake{"NoPartOfACommand", {"farm"}, 64, "hint: pomona farm needs one of slurm,"},
        Mistake{"UnknownPartOfACommand", {"farm", "slrum", "x.toml"}, 64, "did you mean slurm?"},
        Mistake{"UnknownCommand", {"gorw", "tomato", "-o", "x.ply"}, 64, "gorw"},
        Mistake{"MistypedOption", {"grow", "tomato", "--sede", "3", "-o", "x.ply"}, 64, "did you mean --seed"},
        Mistake{"NoOutput", {"grow", "tomato"}, 64, "--output"},
        Mistake{"MistypedOptionThatIsNeeded",
                {"cut", "tomato", "--knive", "half", "-o", "x.ply"},
                64,
                "did you mean --knife?"},
        Mistake{"MistypedOutput", {"grow", "tomato", "--ouput", "x.glb"}, 64, "there is no option --ouput"},
        Mistake{"WordTooMany", {"grow", "tomato", "lemon", "-o", "x.glb"}, 64, "not expected: lemon"},
        Mistake{"MistypedWord", {"grow", "tomato", "--quality", "darft", "-o", "x.glb"}, 64, "did you mean draft?"},
        Mistake{"DetailIsNoNumber", {"grow", "tomato", "--detail", "nan", "-o", "x.glb"}, 64, "number from 0.1 to 4"},
        Mistake{"VariationIsNoNumber", {"grow", "tomato", "--variation", "nan", "-o", "x.glb"}, 64, "from 0 to 2"},
        Mistake{"ExplodeIsNoNumber",
                {"cut", "tomato", "--knife", "half", "--explode", "nan", "-o", "x.glb"},
                64,
                "1 to 10"},
        Mistake{
            "PixelsPerDegreeAreNoNumber", {"compare", "x.png", "x.png", "--ppd", "nan"}, 64, "number from 5 to 500"},
        Mistake{
            "HalfAThread", {"grow", "tomato", "--threads", "1.5", "-o", "x.glb"}, 64, "whole number from 0 to 1024"},
        Mistake{"SeedBeyond64Bits", {"grow", "tomato", "--seed", "18446744073709551616", "-o", "x.glb"}, 64, "--seed"},
        Mistake{"SlicesWithoutUnit", {"cut", "tomato", "--knife", "slices:4.5", "-o", "x.glb"}, 64, "write 4.5mm"},
        Mistake{"TexelWithoutUnit", {"grow", "tomato", "--texel", "0.2", "-o", "x.glb"}, 64, "write 0.2mm"},
        Mistake{"BallOfMetres", {"cut", "tomato", "--knife", "ball:24", "-o", "x.glb"}, 64, "write 24mm"},
        Mistake{"UnknownUnit", {"cut", "tomato", "--knife", "slices:4in", "-o", "x.glb"}, 64, "mm, cm or m"},
        Mistake{"TemplateAsScene",
                {"scene", POMONA_SOURCE_DIR "/templates/tomato.toml", "-o", "x.glb"},
                65,
                "is a template"},
        Mistake{"SceneAsFruit",
                {"cut", POMONA_SOURCE_DIR "/scenes/salad.toml", "--knife", "half", "-o", "x.glb"},
                65,
                "pomona scene takes scenes"},
        Mistake{"SceneAsBatch", {"batch", POMONA_SOURCE_DIR "/scenes/salad.toml", "-o", "x"}, 65, "is a scene"},
        Mistake{"LayoutAsFruit",
                {"cut", POMONA_SOURCE_DIR "/tests/fuzz/corpus/layout/two.json", "--knife", "half", "-o", "x.glb"},
                65,
                "templates are .toml"},
        Mistake{"UnknownEndingBehindTheTemplate", {"cut", "--knife", "half", "tomato", "-o", "x.jpg"}, 64, ".ply .glb"},
        Mistake{"EmptyView", {"grow", "tomato", "--view", "", "-o", "x.png"}, 64, "--view"},
        Mistake{"PictureOfPiecesTooLarge", {"grow", "tomato", "--size", "9000x9000", "-o", "x.png"}, 64, "8192"},
        Mistake{"StandardOutputOfNoFormat", {"grow", "tomato", "-o", "-"}, 64, "--format glb"},
        Mistake{"FormatOfNothing", {"grow", "tomato", "--format", "glb", "-o", "x.ply"}, 64, "add -o -"},
        Mistake{
            "StandardOutputTwice", {"grow", "tomato", "--json", "--format", "ply", "-o", "-"}, 64, "standard output"},
        Mistake{"PiecesAreAnOutput",
                {"cut", "tomato", "--knife", "half", "--pieces", "./x.glb", "-o", "x.glb"},
                64,
                "is an output already"},
        Mistake{"StatisticsAreAnOutput",
                {"grow", "tomato", "--stats", "./x.ply", "-o", "x.ply"},
                64,
                "is an output already: -o x.ply"},
        Mistake{"StatisticsArePieces",
                {"cut", "tomato", "--knife", "half", "--pieces", "x.json", "--stats", "x.json", "-o", "x.glb"},
                64,
                "is an output already: --pieces x.json"},
        Mistake{"TwoDocumentsOnStandardOutput",
                {"grow", "tomato", "--json", "--stats", "-", "-o", "x.ply"},
                64,
                "both write to standard output"},
        Mistake{"PiecesAndAnAnswerOnStandardOutput",
                {"cut", "tomato", "--knife", "half", "--json", "--pieces", "-", "-o", "x.glb"},
                64,
                "both write to standard output"},
        Mistake{"PiecesInNoFolder",
                {"cut", "tomato", "--knife", "half", "--pieces", "no/x.json", "-o", "x.glb"},
                73,
                "mkdir -p no"},
        Mistake{"FolderAsOutput", {"grow", "tomato", "-o", "/tmp/../tmp"}, 64, "has no ending"},
        Mistake{"DeviceAsTemplate", {"grow", "/dev/null", "-o", "x.ply"}, 66, "is a device or a pipe"},
        Mistake{"UnknownEnding", {"grow", "tomato", "-o", "x.jpg"}, 64, ".ply .glb .usda .obj .stl .pov .png"},
        Mistake{"SameOutputTwice", {"grow", "tomato", "-o", "x.ply", "-o", "./x.ply"}, 64, "twice"},
        Mistake{"NoLevels", {"grow", "tomato", "--lod", "0", "-o", "x.glb"}, 64, "--lod"},
        Mistake{"NineLevels", {"cut", "tomato", "--knife", "half", "--lod", "9", "-o", "x.glb"}, 64, "--lod"},
        Mistake{"LevelsForGodot",
                {"grow", "tomato", "--lod", "2", "--engine", "godot", "-o", "x.glb"},
                64,
                "Godot makes levels"},
        Mistake{"InstancesForUnreal",
                {"grow", "tomato", "--instances", "--engine", "unreal", "-o", "x.glb"},
                64,
                "EXT_mesh_gpu_instancing"},
        Mistake{"AnotherEngine", {"grow", "tomato", "--engine", "quake", "-o", "x.glb"}, 64, "--engine"},
        Mistake{"RipenessesWithoutTextures",
                {"grow", "tomato", "--ripeness-variants", "0,1", "-o", "x.glb"},
                64,
                "add --texture"},
        Mistake{"MapsWithoutTextures", {"grow", "tomato", "--maps-dir", "maps", "-o", "x.glb"}, 64, "add --texture"},
        Mistake{"MapsOfAPicture",
                {"grow", "tomato", "--texture", "64", "--maps-dir", "maps", "-o", "x.png"},
                64,
                "one .glb's textures"},
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
                "none.svg: error: there is no such file"},
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
        Mistake{"CheckMissingFile", {"check", "missing.toml"}, 66, "no such file"},
        Mistake{"OptionOfAnotherCommand",
                {"grow", "tomato", "--knife", "half", "-o", "x.glb"},
                64,
                "--knife\n  hint: it is an option of pomona cut; see"},
        Mistake{"OptionWithOneDash", {"grow", "tomato", "-seed", "3", "-o", "x.glb"}, 64, "did you mean --seed?"},
        Mistake{"LetterThatIsNoOption", {"-v"}, 64, "there is no option -v"},
        Mistake{"SceneByNameAsFruit",
                {"grow", "salad", "-o", "x.glb"},
                66,
                "there is no template \"salad\"\n  hint: salad is a scene: pomona scene takes scenes"},
        Mistake{"FruitByNameAsScene",
                {"scene", "tomato", "-o", "x.glb"},
                66,
                "tomato is a template: pomona grow and pomona cut take templates"},
        Mistake{"CheckMistypedScene", {"check", "salda"}, 66, "or style \"salda\"\n  hint: did you mean salad?"},
        Mistake{
            "OwnNameWithAnEnding", {"grow", "tomato.toml", "-o", "x.glb"}, 66, "the program's own is called tomato"},
        Mistake{"StyleInTheShellsHome",
                {"grow", "tomato", "--style=~/own.toml", "-o", "x.png"},
                66,
                "hint: ~ is not read as your home here"},
        Mistake{"DrawingInTheShellsHome",
                {"cut", "radish", "--knife", "stroke:~/a.svg#a", "-o", "x.glb"},
                66,
                "hint: ~ is not read as your home here"},
        Mistake{"OutputInTheShellsHome", {"grow", "tomato", "-o", "~/x.ply"}, 73, "write $HOME"},
        Mistake{"MissingFolderOfTwoWords", {"grow", "tomato", "-o", "no such/x.ply"}, 73, "hint: mkdir -p 'no such'"},
        Mistake{"BatchInAMissingFolder", {"batch", "small_batch", "-o", "no/such"}, 73, "hint: mkdir -p no"},
        Mistake{"BatchInNoFolder", {"batch", "small_batch", "-o", ""}, 64, "names no folder"},
        Mistake{"MapThatIsNoPng", {"compare", "x.png", "y.png", "--map", "x.jpg"}, 64, "it is written as .png"},
        Mistake{"PageThatIsNoHtml", {"compare", "x.png", "y.png", "--html", "x"}, 64, "it is written as .html"},
        Mistake{"MistypedTolerance", {"compare", "x.png", "y.png", "--tolerance", "clos"}, 64, "did you mean close?"},
        Mistake{"StudioOfSurfaces",
                {"studio", POMONA_SOURCE_DIR "/templates/kidney.ply"},
                65,
                "the studio opens templates (.toml)"},
        Mistake{"StudioOfADrawing", {"studio", POMONA_SOURCE_DIR "/templates/kiwi.svg"}, 65, "templates are .toml"},
        Mistake{"StudioOfAScene", {"studio", POMONA_SOURCE_DIR "/scenes/salad.toml"}, 65, "pomona scene takes scenes"}),
    [](const auto& tested) { return tested.param.name; });

TEST(Help, IsPrintedByEveryCommand) {
  for (const char* command : {"list", "check", "sketch", "grow", "cut", "scene", "compare"}) {
    const Outcome outcome = run_pomona({command, "-h"});
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_THAT(outcome.out, HasSubstr(command));
    EXPECT_THAT(outcome.err, IsEmpty());
  }
}

TEST(Help, AnswersToTheWordsPeopleTry) {
  EXPECT_EQ(run_pomona({"help", "cut"}).out, run_pomona({"cut", "-h"}).out);
  EXPECT_EQ(run_pomona({"help"}).out, run_pomona({"-h"}).out);
  for (const char* word : {"version", "-V"}) {
    const Outcome outcome = run_pomona({word});
    EXPECT_EQ(outcome.status, 0) << word;
    EXPECT_EQ(outcome.out, run_pomona({"--version"}).out);
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

TEST(List, NamesOnesOwnTemplatesAfterTheProgramsAndNothingElse) {
  const TemporaryFolder folder;
  const std::filesystem::path sources = POMONA_SOURCE_DIR;
  std::filesystem::create_directory(folder.path() / "templates");
  std::filesystem::copy(sources / "templates/radish.toml", folder.path() / "my_radish.toml");
  std::filesystem::copy(sources / "templates/radish.toml", folder.path() / "templates/our_radish.toml");
  std::filesystem::copy(sources / "scenes/salad.toml", folder.path() / "my_salad.toml");
  const Outcome outcome = run_pomona({"list"}, folder.path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nmy_radish\t"));
  EXPECT_THAT(outcome.out, HasSubstr("\nour_radish\t"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("my_salad")));
  EXPECT_GT(outcome.out.find("my_radish"), outcome.out.find("watermelon"));
}

TEST(StandardOutput, TakesTheBytesOfTheFile) {
  const TemporaryFolder folder;
  const std::vector<std::string> grow = {"grow", "radish", "--detail", "0.1", "--quiet", "-o"};
  for (const char* format : {"ply", "glb", "obj", "stl"}) {
    std::vector<std::string> file = grow, stream = grow;
    file.push_back(std::string("x.") + format);
    stream.insert(stream.end(), {"-", "--format", format});
    ASSERT_EQ(run_pomona(file, folder.path()).status, 0);
    const Outcome outcome = run_pomona(stream, folder.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out == bytes_of(folder.path() / file.back())) << format;
  }
}

TEST(StandardOutput, TakesAFormatAsEndingsAreWritten) {
  const Outcome outcome = run_pomona({"grow", "radish", "--detail", "0.1", "--quiet", "-o", "-", "--format", ".ply"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::StartsWith("ply\n"));
}

TEST(MissingInput, SuggestsAFileOfNearlyThatName) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "kiwano.toml") << "format = 1\n";
  std::ofstream(folder.path() / "kiwano.svg") << "<svg/>";
  const Outcome outcome = run_pomona({"check", "kiwnao.toml"}, folder.path());
  EXPECT_EQ(outcome.status, 66);
  EXPECT_EQ(outcome.err, "kiwnao.toml: error: there is no such file\n  hint: did you mean kiwano.toml?\n");
  EXPECT_THAT(run_pomona({"check", "fig1.toml"}, folder.path()).err, Not(HasSubstr("hint")));
}

TEST(StandardOutput, ThatIsFullEndsWithItsStatus) {
  for (const std::string words :
       {"list", "--version", "check tomato", "grow radish --detail 0.1 --quiet -o - --format ply"}) {
    const int status = std::system((POMONA_PROGRAM " " + words + " >/dev/full 2>/dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 74) << words;
  }
}

TEST(Outputs, WarnOfOptionsThatHaveNoEffect) {
  const TemporaryFolder folder;
  const Outcome outcome = run_pomona(
      {"grow",  "radish",   "--detail", "0.1",         "--texel",       "1mm", "--view",       "top", "--size",
       "80x60", "--dpi",    "300",      "--sheets",    "--variation",   "2",   "--aov-format", "exr", "--lod",
       "2",     "--engine", "unity",    "--instances", "--feature-ids", "-o",  "X.OBJ"},
      folder.path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* option : {"--texel", "--view", "--size", "--dpi", "--sheets", "--variation", "--aov-format", "--lod",
                             "--engine", "--instances", "--feature-ids"})
    EXPECT_THAT(outcome.err, HasSubstr(std::string("warning: ") + option));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "X.OBJ"));
}

TEST(Outputs, DoNotTakeThePlaceOfWhatIsRead) {
  const TemporaryFolder folder;
  const std::filesystem::path templates = POMONA_SOURCE_DIR "/templates";
  for (const char* name : {"cherry.toml", "cherry.svg"})
    std::filesystem::copy_file(templates / name, folder.path() / name);
  const std::string toml = bytes_of(folder.path() / "cherry.toml"), svg = bytes_of(folder.path() / "cherry.svg");
  const std::vector<std::vector<std::string>> commands{
      {"grow", "cherry.toml", "-o", "x.stl", "--stats", "./cherry.toml"},
      {"grow", "cherry.toml", "-o", "cherry.svg"},
      {"cut", "cherry.toml", "--knife", "half", "-o", "x.stl", "--pieces", "cherry.toml"}};
  for (const std::vector<std::string>& words : commands) {
    const Outcome outcome = run_pomona(words, folder.path());
    EXPECT_EQ(outcome.status, 64) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("is read by this command"));
  }
  EXPECT_TRUE(bytes_of(folder.path() / "cherry.toml") == toml);
  EXPECT_TRUE(bytes_of(folder.path() / "cherry.svg") == svg);
}

TEST(Outputs, MayHaveNamesThatAreNoUtf8) {
  const TemporaryFolder folder;
  const Outcome outcome = run_pomona({"grow", "radish", "--detail", "0.1", "--json", "-o", "b\xff.ply"}, folder.path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"bytes\""));

  // All outputs of a template whose name is no UTF-8: assets, pages, lists of pieces, maps, ground truth.
  const std::filesystem::path templates = POMONA_SOURCE_DIR "/templates";
  std::filesystem::copy_file(templates / "egg.toml", folder.path() / "e\xff.toml");
  const std::vector<std::vector<std::string>> commands{
      {"grow", "e\xff.toml", "-o", "x.html", "-o", "x.pomona"},
      {"cut",   "e\xff.toml", "--knife", "half",      "--detail", "0.2",        "--size",
       "64x48", "--pieces",   "p.json",  "--texture", "64",       "--maps-dir", "maps",
       "-o",    "x\xff.glb",  "-o",      "x\xff.png", "--aov",    "truth"}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"--quality", "draft", "--quiet"});
    const Outcome each = run_pomona(words, folder.path());
    EXPECT_EQ(each.status, 0) << each.err;
  }
}

TEST(Errors, ShowNoControlCharacters) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "x.toml") << "[symmetry]\n\"\\u001b[2J\" = 1\n";
  const Outcome outcome = run_pomona({"check", "x.toml"}, folder.path());
  EXPECT_EQ(outcome.status, 65);
  EXPECT_THAT(outcome.err, HasSubstr("\\x1b[2J"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b")));
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
