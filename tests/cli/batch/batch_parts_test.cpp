// Unit tests of the parts of batches.
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch/memory_budget.h"
#include "cli/batch/sizes.h"
#include "cli/batch/summary/tally.h"
#include "cli/batch/workplace.h"
#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The maximum memory that 40 items of `each` bytes borrowed at once on four threads.
std::uint64_t max_lent(std::uint64_t budget_bytes, std::uint64_t each) {
  MemoryBudget budget(budget_bytes);
  std::atomic<std::uint64_t> lent = 0, max = 0;
  parallel_for(40, {4}, [&](std::size_t) {
    const MemoryBudget::Loan loan(budget, each);
    const std::uint64_t now = lent += each;
    for (std::uint64_t seen = max; seen < now && !max.compare_exchange_weak(seen, now);) {
    }
    lent -= each;
  });
  return max;
}

TEST(MemoryBudget, IsNeverExceededByManyItems) {
  EXPECT_LE(max_lent(250, 100), 200u);
  EXPECT_LE(max_lent(399, 100), 300u);
}

TEST(MemoryBudget, LetsAnItemThatIsTooLargePassAlone) { EXPECT_EQ(max_lent(50, 100), 100u); }

TEST(Shard, IsReadAsTyped) {
  EXPECT_EQ(parse_shard("3/8").number, 3);
  EXPECT_EQ(parse_shard("3/8").count, 8);
  EXPECT_EQ(parse_shard("").count, 1);
  for (const char* text : {"0/8", "9/8", "1/0", "1", "/", "1/", "a/2", "1/2/3", " 1/2", "1/4294967297"})
    EXPECT_THROW(parse_shard(text), Error) << text;
}

TEST(Memory, IsReadAsTyped) {
  EXPECT_EQ(parse_memory("2GB"), 2'000'000'000u);
  EXPECT_EQ(parse_memory("1.5G"), 1'500'000'000u);
  EXPECT_EQ(parse_memory("500MB"), 500'000'000u);
  for (const char* text : {"2", "GB", "0GB", "-1GB", "1e30GB", "nanGB", "2 GBs"})
    EXPECT_THROW(parse_memory(text), Error) << text;
}

TEST(Tally, SaysHowFarItIsAndHowLongItTakes) {
  EXPECT_EQ(progress_text({.total = 500}), "0/500, 0 failed");
  EXPECT_EQ(progress_text({.total = 500, .found = 20, .made = 80, .failed = 2, .seconds = 10}),
            "100/500, 2 failed, 8.0 a second, 50 s left");
  EXPECT_EQ(duration_text(600), "10 min");
  EXPECT_EQ(duration_text(36000), "10.0 h");
}

TEST(Workplace, PutsItemsWholeAndInPlaceOfWhatIsThere) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  {
    Workplace workplace(out, {});
    const NamedFile first[] = {{"a.txt", "a"}, {"b.txt", "b"}}, second[] = {{"c.txt", "c"}};
    workplace.put_item("entry/000/001", first);
    EXPECT_EQ(text_of(out / "entry/000/001/b.txt"), "b");
    workplace.put_item("entry/000/001", second);
    EXPECT_EQ(text_of(out / "entry/000/001/c.txt"), "c");
    EXPECT_FALSE(fs::exists(out / "entry/000/001/a.txt"));

    // A file larger than the buffer is written unchanged.
    const std::string line(1000, 'x');
    workplace.put_file("long.txt", [&](const Workplace::Writer& write) {
      for (int k = 0; k < 1000; ++k) write(line);
    });
    EXPECT_EQ(fs::file_size(out / "long.txt"), 1000000u);
  }
  EXPECT_FALSE(fs::exists(out / ".pomona")) << "whoever is last removes what is temporary";
}

TEST(Workplace, IsSharedByShardsAndByNobodyElse) {
  const TemporaryFolder folder;
  const Workplace first(folder.path(), {1, 2});
  EXPECT_THROW(Workplace(folder.path(), {1, 2}), Error);
  EXPECT_THROW(Workplace(folder.path(), {}), Error);
  { const Workplace second(folder.path(), {2, 2}); }
  EXPECT_TRUE(fs::exists(folder.path() / ".pomona")) << "the first is still at work";
}

TEST(Workplace, ClearsWhatAKilledRunOfTheSameShardHasLeft) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / ".pomona/1-of-2/7");
  fs::create_directories(folder.path() / ".pomona/2-of-2/7");
  const Workplace first(folder.path(), {1, 2});
  EXPECT_FALSE(fs::exists(folder.path() / ".pomona/1-of-2/7"));
  EXPECT_TRUE(fs::exists(folder.path() / ".pomona/2-of-2/7")) << "another shard's is its own business";
}

}  // namespace
}  // namespace pomona
