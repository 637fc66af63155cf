#include "cli/farm/shard_progress.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>

#include "cli/batch/assemble.h"
#include "cli/batch/finished_item.h"
#include "generator/batch/batch_record.h"
#include "render/export/transaction/durable_file.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

enum class Found : char { missing, done, failed };

/// The state of some items, in order: few enough at a time that memory does not grow with the batch.
std::vector<Found> look_at(const fs::path& folder, const RecordedEntry& entry, std::int64_t first, std::int64_t count,
                           Threads threads) {
  std::vector<Found> found(static_cast<std::size_t>(count));
  parallel_for(found.size(), threads, [&](std::size_t i) {
    const std::string item = item_path(entry.name, entry.items, first + static_cast<std::int64_t>(i));
    const auto there = finished_item(folder, item);
    if (there) found[i] = there->facts.error.empty() ? Found::done : Found::failed;
  });
  return found;
}

/// Shards take individuals in turn, over all entries; the items of one stay together.
void count_items(BatchProgress& progress, const fs::path& folder, const RecordedBatch& batch, Threads threads) {
  constexpr std::int64_t at_a_time = 10'000;
  std::int64_t before = 0;  // number of individuals of the entries so far
  for (const RecordedEntry& entry : batch.entries) {
    for (std::int64_t first = 0; first < entry.items; first += at_a_time) {
      const std::int64_t count = std::min(at_a_time, entry.items - first);
      const std::vector<Found> found = look_at(folder, entry, first, count, threads);
      for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t individual = before + (first + i) / entry.items_of_a_variant;
        ShardProgress& shard = progress.shards[static_cast<std::size_t>(individual) % progress.shards.size()];
        ++shard.items;
        if (found[static_cast<std::size_t>(i)] == Found::done) ++shard.done;
        if (found[static_cast<std::size_t>(i)] == Found::failed) ++shard.failed;
      }
    }
    before += entry.items / entry.items_of_a_variant;
  }
}

/// Only trying to lock tells whether somebody holds the lock; flock() works across machines, too.
void look_at_lock(ShardProgress& shard, const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  shard.begun = file.is_open();
  shard.at_work = shard.begun && ::flock(file.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

BatchProgress progress_of(const fs::path& folder, int tasks, Threads threads) {
  // The items.
  BatchProgress progress;
  progress.shards.resize(static_cast<std::size_t>(tasks));
  const std::string record = batch_record_in(folder);
  if (!record.empty()) {
    const RecordedBatch batch = parse_batch_record(record, (folder / "batch.json").string());
    progress.name = batch.name;
    count_items(progress, folder, batch, threads);
  }

  // The locks of runs.
  std::error_code ignored;
  progress.merged = fs::exists(folder / "manifest.json", ignored);
  for (int shard = 1; shard <= tasks; ++shard) {
    const std::string part = std::to_string(shard) + "-of-" + std::to_string(tasks) + ".lock";
    look_at_lock(progress.shards[static_cast<std::size_t>(shard - 1)], folder / ".pomona" / part);
  }
  return progress;
}

}  // namespace pomona
