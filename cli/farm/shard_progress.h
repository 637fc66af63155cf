// How far each shard of a batch is, read from the batch's folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/base/parallel.h"

namespace pomona {

struct ShardProgress {
  std::int64_t items = 0, done = 0, failed = 0;
  bool begun = false;    ///< its lock is there: a run is at work on it, or was killed
  bool at_work = false;  ///< a run holds the lock, on whichever machine
  std::int64_t missing() const { return items - done - failed; }
};

struct BatchProgress {
  std::string name;     ///< of the batch; empty if no run has begun it
  bool merged = false;  ///< manifest.json is there
  std::vector<ShardProgress> shards;
};

/// Reads every item's record. A shard's lock is asked for, for an instant, where its file is there.
/// \throws Error (bad_data) if batch.json cannot be read.
BatchProgress progress_of(const std::filesystem::path& folder, int tasks, Threads threads);

}  // namespace pomona
