#include "generator/batch/batch_plan.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/batch/batch_record.h"
#include "generator/batch/item_record.h"
#include "generator/batch/template_hash.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path templates = fs::path(POMONA_SOURCE_DIR) / "templates";

BatchPlan plan_of(const std::string& entries, int seed = 1) {
  const std::string head = "[batch]\nformat = 1\nname = \"b\"\nseed = " + std::to_string(seed) + "\n";
  return planned(parse_batch(head + entries, "b.toml"),
                 {.find = [](const std::string& name) { return templates / (name + ".toml"); },
                  .all =
                      [] {
                        return std::vector<fs::path>{templates / "kiwi.toml", templates / "radish.toml"};
                      }});
}

std::string entry(const std::string& name, const std::string& rest) {
  return "[[entry]]\nname = \"" + name + "\"\n" + rest;
}

TEST(BatchPlan, MultipliesItsLists) {
  const BatchPlan plan =
      plan_of(entry("a",
                    "templates = [\"tomato\", \"pepper\"]\nseeds = [1, 2, 3]\nfolds = [3, 4]\n"
                    "ripeness = [0.5, 1, 1.5]\nknives = [\"half\", \"across\"]\n"
                    "quality = [\"draft\", \"final\"]\nlod = [0, 1]\nformats = [\"glb\", \"ply\"]\n"));
  EXPECT_EQ(plan.variants(), 2 * 3 * 2 * 3);
  EXPECT_EQ(plan.items(), plan.variants() * 2 * 2 * 2);

  // Each combination occurs once.
  std::set<std::tuple<std::size_t, std::uint64_t, int, double, std::size_t, Quality, int>> seen;
  std::int64_t next = 0;
  for (std::int64_t v = 0; v < plan.variants(); ++v) {
    const BatchVariant variant = variant_at(plan, v);
    for (const BatchItem& item : items_of(plan.entries[0], variant)) {
      EXPECT_EQ(item.number, next++);
      seen.emplace(variant.fruit, variant.seed, *variant.folds, *variant.ripeness, item.knives, item.quality, item.lod);
    }
  }
  EXPECT_EQ(static_cast<std::int64_t>(seen.size()), plan.items());
}

TEST(BatchPlan, NewVariantsHaveSeedsOfTheirOwn) {
  const BatchPlan plan = plan_of(entry("a", "templates = \"all\"\ncount = 500\n"));
  std::set<std::uint64_t> seeds;
  for (std::int64_t v = 0; v < plan.variants(); ++v) {
    const std::uint64_t seed = variant_at(plan, v).seed;
    EXPECT_GT(seed, 0u);
    EXPECT_LT(seed, std::uint64_t{1} << 53);
    seeds.insert(seed);
  }
  EXPECT_EQ(seeds.size(), 1000u);
}

TEST(BatchPlan, SeedsRestOnTheBatchSeedTheEntryAndTheNumberAlone) {
  const BatchPlan alone = plan_of(entry("a", "templates = \"kiwi\"\ncount = 3\n"));
  const BatchPlan later = plan_of(entry("b", "templates = \"kiwi\"\ncount = 2\n") +
                                  entry("a", "templates = \"kiwi\"\ncount = 5\nquality = \"final\"\n"));
  for (int n = 0; n < 3; ++n) EXPECT_EQ(variant_at(alone, n).seed, variant_at(later, 2 + n).seed);
  EXPECT_NE(variant_at(later, 0).seed, variant_at(later, 2).seed) << "another entry";
  EXPECT_NE(variant_at(alone, 0).seed, variant_at(plan_of(entry("a", "templates = \"kiwi\"\ncount = 1\n"), 2), 0).seed)
      << "another batch";
}

TEST(BatchPlan, SharesATotalOutAmongTheTemplatesInTurn) {
  const BatchPlan plan = plan_of(entry("a", "templates = \"all\"\ntotal = 5\n"));
  ASSERT_EQ(plan.variants(), 5);
  for (int n = 0; n < 5; ++n) EXPECT_EQ(plan.templates[variant_at(plan, n).fruit].name, n % 2 ? "radish" : "kiwi");
}

TEST(BatchPlan, NoFolderHasMoreThanAThousandEntries) {
  EXPECT_EQ(item_folder(1, 0), "000");
  EXPECT_EQ(item_folder(1000, 999), "999");
  EXPECT_EQ(item_folder(1001, 1000), "001/000");
  EXPECT_EQ(item_folder(1000000, 999999), "999/999");
  EXPECT_EQ(item_folder(10000000, 1234567), "001/234/567");
}

TEST(BatchPlan, HoldsTenMillionItems) {
  const BatchPlan plan =
      plan_of(entry("a", "templates = \"kiwi\"\ncount = 5000000\nknives = [\"half\", \"across\"]\n"));
  EXPECT_EQ(plan.items(), 10000000);
  EXPECT_EQ(items_of(plan.entries[0], variant_at(plan, 4999999)).back().number, 9999999);
}

TEST(BatchRecord, TellsOneBatchFromAnotherAndIsReadBack) {
  const std::string text = entry("a", "templates = \"kiwi\"\ncount = 2\nknives = \"half\"\n");
  const std::string record = batch_record(plan_of(text), "pomona 1");
  EXPECT_EQ(record, batch_record(plan_of(text), "pomona 1"));
  EXPECT_NE(record, batch_record(plan_of(text), "pomona 2"));
  EXPECT_NE(record, batch_record(plan_of(text, 2), "pomona 1"));
  EXPECT_NE(record, batch_record(plan_of(text + "thumbnail = 64\n"), "pomona 1"));

  const RecordedBatch batch = parse_batch_record(record, "batch.json");
  EXPECT_EQ(batch.name, "b");
  EXPECT_EQ(batch.items(), 2);
  ASSERT_EQ(batch.entries.size(), 1u);
  EXPECT_EQ(batch.entries[0].name, "a");
}

TEST(BatchRecord, NamesADrawingWholeAndChangesWithIt) {
  const TemporaryFolder folder;
  const auto record_of = [&](const char* end) {
    std::ofstream(folder / "cut #2.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><path id="w" d="M -9,-20 L 9,)"
                                         << end << R"("/></svg>)";
    const std::string text = "[batch]\nformat = 1\nname = \"b\"\nseed = 1\n" +
                             entry("a", "templates = \"kiwi\"\ncount = 2\nknives = \"stroke:cut #2.svg#w\"\n");
    return batch_record(
        planned(parse_batch(text, folder / "b.toml"),
                {.find = [](const std::string& name) { return templates / (name + ".toml"); }, .all = {}}),
        "pomona 1");
  };
  const std::string first = record_of("-30");
  EXPECT_THAT(first, HasSubstr("\"file\": \"cut #2.svg\""));
  EXPECT_EQ(first, record_of("-30"));
  EXPECT_NE(first, record_of("-10"));
}

TEST(BatchRecord, RefusesNamesThatLeadElsewhere) {
  const std::string record = batch_record(plan_of(entry("a", "templates = \"kiwi\"\ncount = 2\n")), "pomona 1");
  std::string bad = record;
  bad.replace(bad.find("\"name\": \"a\""), 11, "\"name\": \"..\"");
  EXPECT_THROW(parse_batch_record(bad, "batch.json"), Error);
  EXPECT_THROW(parse_batch_record("{}", "batch.json"), Error);
  EXPECT_THROW(parse_batch_record("", "batch.json"), Error);
}

TEST(ItemRecord, IsOneLineThatIsReadBack) {
  const BatchPlan plan = plan_of(entry("a", "templates = \"kiwi\"\nseeds = 9\nknives = [[\"half\", \"across\"]]\n"));
  const BatchVariant variant = variant_at(plan, 0);
  const BatchItem item = items_of(plan.entries[0], variant)[0];
  const ItemOutcome outcome{.files = {{"kiwi.glb", 12, "ab"}}, .warnings = {"two\nlines"}};
  const std::string record = item_record(plan, variant, item, outcome);
  EXPECT_EQ(record.find('\n'), record.size() - 1);

  const RecordedItem read = parse_item_record(record, "item.json");
  EXPECT_EQ(read.item, "a/000");
  EXPECT_EQ(read.template_name, "kiwi");
  EXPECT_EQ(read.seed, 9u);
  EXPECT_EQ(read.knives, "half across");
  ASSERT_EQ(read.files.size(), 1u);
  EXPECT_EQ(read.files[0].bytes, 12u);
  EXPECT_THROW(parse_item_record(R"({"item":"a/000"})", "item.json"), Error);
}

TEST(TemplateHash, ChangesWithTheSketchThatTheTemplateNames) {
  const TemporaryFolder folder;
  fs::copy(templates / "tomato.toml", folder.path());
  fs::copy(templates / "tomato.svg", folder.path());
  const std::string before = template_hash(folder / "tomato.toml");
  EXPECT_EQ(before, template_hash(templates / "tomato.toml"));
  std::ofstream(folder / "tomato.svg", std::ios::app) << "<!-- -->";
  EXPECT_NE(before, template_hash(folder / "tomato.toml"));
}

TEST(TemplateHash, ChangesWithWhatIsPlacedInWhatItPlaces) {
  const TemporaryFolder folder;
  for (const char* name : {"bowl.toml", "bunch.toml", "berry.toml"})
    fs::copy(fs::path(POMONA_SOURCE_DIR) / "tests/compose/placed" / name, folder.path());
  const std::string before = template_hash(folder / "bowl.toml");
  std::ofstream(folder / "berry.toml", std::ios::app) << "# riper\n";
  EXPECT_NE(before, template_hash(folder / "bowl.toml"));
}

}  // namespace
}  // namespace pomona
