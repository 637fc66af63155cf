// The progress of each shard, read from the batch's folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/base/parallel.h"

namespace pomona {

struct ShardProgress {
  std::int64_t items = 0, done = 0, failed = 0;
  bool begun = false;    ///< its lock exists: a run is at work on it, or was killed
  bool at_work = false;  ///< a run holds the lock, on any machine
  std::int64_t missing() const { return items - done - failed; }
};

struct BatchProgress {
  std::string name;     ///< name of the batch; empty if no run has begun it
  bool merged = false;  ///< manifest.json exists
  std::vector<ShardProgress> shards;
};

/// Reads every item's record. Tries a shard's lock for an instant, if its file exists.
/// \throws Error (bad_data) if batch.json cannot be read.
BatchProgress progress_of(const std::filesystem::path& folder, int tasks, Threads threads);

}  // namespace pomona
