#include "generator/batch/batch_file.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/batch/batch_plan.h"

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

/// Each file's first line says what is expected: "# expects LINE:COLUMN: part of the message".
TEST(BatchFile, BadBatchesAreToldWhereAndWhy) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(source_dir / "tests/batch/bad")) {
    SCOPED_TRACE(entry.path().filename().string());
    std::string expected;
    std::getline(std::ifstream(entry.path()) >> std::ws, expected);
    const std::string place = expected.substr(10, expected.find(": ") - 10);
    const std::string message = expected.substr(expected.find(": ") + 2);
    ++files;
    try {
      planned(read_batch(entry.path()), of_the_tree());
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      const std::string text = to_string(error.diagnostics().front());
      EXPECT_THAT(text, StartsWith(entry.path().string() + ":" + place + ":"));
      EXPECT_THAT(text, HasSubstr(message));
    }
  }
  EXPECT_GE(files, 16);
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

  // What [batch] says holds where an entry says nothing else.
  EXPECT_THAT(batch.entries[0].assets.qualities, ElementsAre(Quality::draft, Quality::final));
  EXPECT_THAT(batch.entries[1].assets.qualities, ElementsAre(Quality::reference));
  ASSERT_THAT(batch.entries[1].knives, SizeIs(3));
  EXPECT_THAT(batch.entries[1].knives[1], SizeIs(2));
  EXPECT_THAT(batch.entries[1].knives[2], SizeIs(0));
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
