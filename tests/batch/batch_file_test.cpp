#include "generator/batch/batch_file.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/batch/batch_plan.h"
#include "tests/base/bad_files.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

const fs::path source_dir = POMONA_SOURCE_DIR;

TemplateSource of_the_tree() {
  return {.find = [](const std::string& name) { return source_dir / "templates" / (name + ".toml"); }, .all = {}};
}

TEST(BatchFile, BadBatchesAreToldWhereAndWhy) {
  const auto read = [](const fs::path& file) { planned(read_batch(file), of_the_tree()); };
  EXPECT_GE(expect_told_where_and_why(source_dir / "tests/batch/bad", read), 17);
}

TEST(BatchFile, ReadsTheShippedBatches) {
  for (const char* name : {"small_batch", "thousand_pieces"}) {
    const fs::path file = source_dir / "scenes" / (std::string(name) + ".toml");
    EXPECT_TRUE(is_batch_file(file));
    EXPECT_EQ(read_batch(file).name, name);
  }
  EXPECT_FALSE(is_batch_file(source_dir / "scenes/salad.toml"));
  EXPECT_FALSE(is_batch_file(source_dir / "templates/tomato.toml"));
}

TEST(BatchFile, TakesOneValueForAListOfOne) {
  const BatchDescription batch = parse_batch(R"(
[batch]
format = 1
name = "b"
quality = ["draft", "final"]
[[entry]]
name = "a"
templates = "tomato"
seeds = 7
knives = "half"
[[entry]]
name = "c"
templates = ["kiwi", "lemon"]
total = 3
knives = ["half", ["half", "across"], []]
quality = "reference"
)",
                                             "b.toml");
  ASSERT_THAT(batch.entries, SizeIs(2));
  EXPECT_THAT(batch.entries[0].seeds, ElementsAre(7));
  ASSERT_THAT(batch.entries[0].knives, SizeIs(1));
  EXPECT_THAT(batch.entries[0].knives[0], SizeIs(1));

  // Values of [batch] are defaults of the entries.
  EXPECT_THAT(batch.entries[0].assets.qualities, ElementsAre(Quality::draft, Quality::final));
  EXPECT_THAT(batch.entries[1].assets.qualities, ElementsAre(Quality::reference));
  ASSERT_THAT(batch.entries[1].knives, SizeIs(3));
  EXPECT_THAT(batch.entries[1].knives[1], SizeIs(2));
  EXPECT_THAT(batch.entries[1].knives[2], SizeIs(0));
}

TEST(BatchFile, TakesColoursOnVerticesBesideTextures) {
  const BatchDescription batch = parse_batch(
      "[batch]\nformat = 1\nname = \"b\"\ntexture = [0, 64]\n[[entry]]\nname = \"a\"\ncount = 1\ntemplates = \"fig\"\n",
      "b.toml");
  EXPECT_THAT(batch.entries[0].assets.textures, ElementsAre(0, 64));
}

TEST(BatchFile, TellsMissingTemplatesAtTheirPlace) {
  const auto batch = parse_batch(
      "[batch]\nformat = 1\nname = \"b\"\n[[entry]]\nname = \"a\"\ncount = 1\ntemplates = [\"x\"]\n", "b.toml");
  const TemplateSource nothing{
      .find = [](const std::string&) -> fs::path { throw Error(ExitStatus::input_missing, "there is no template"); },
      .all = {}};
  try {
    planned(batch, nothing);
    FAIL() << "was planned";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::input_missing);
    EXPECT_THAT(to_string(error.diagnostics().front()), StartsWith("b.toml:7:14: error: there is no template"));
  }
}

}  // namespace
}  // namespace pomona
