// The progress of a batch on a farm: its folder and its queue, side by side.
#pragma once

#include <filesystem>
#include <string>

#include "cli/farm/farm_folder.h"
#include "cli/farm/shard_progress.h"
#include "cli/farm/slurm_queue.h"

namespace pomona {

struct FarmStatus {
  std::filesystem::path folder;
  BatchProgress batch;
  QueuedJobs jobs;
  QueueState queue;

  /// Every item is there, none has failed, and the shards are merged.
  bool is_complete() const;
};

/// One of "running", "waiting" (in the queue), "stopped" (its lock exists, but no run holds it), "missing" (items are
/// missing, and no run makes them), "failed" (all items exist, some failed), "done".
/// \param shard from 1
std::string shard_state(const FarmStatus& status, int shard);

/// A line for each shard and one for all: shard, state, done, failed, missing, Slurm's state; columns with a heading.
std::string as_table(const FarmStatus& status);

/// The same for programs.
std::string as_json(const FarmStatus& status);

}  // namespace pomona
