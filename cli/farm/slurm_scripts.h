// What Slurm is given: a script for the tasks of an array, one for the merge that waits for them, and the words of
// sbatch.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/farm/farm_job.h"

namespace pomona {

struct SlurmOptions {
  int at_once = 0;                  ///< most tasks that run at a time; 0 = no limit
  int retries = 2;                  ///< how often a task tries again by itself
  std::vector<std::string> sbatch;  ///< further options of sbatch: "--partition=night"
};

/// Task N makes shard N. What it says goes to LOGS/shard-N.txt. A run that ended with 74 or 75, or by a signal, is
/// tried again after 10 s, 20 s, ...; every other status is the task's.
std::string shard_script(const FarmJob& job, const SlurmOptions& options, const std::filesystem::path& logs);

/// Merges; what it says goes to LOGS/merge.txt.
std::string merge_script(const FarmJob& job, const SlurmOptions& options, const std::filesystem::path& logs);

/// sbatch and its words. No path stands in them but the script's: sbatch gives '%' and '\' in paths a meaning.
/// \throws Error (usage) for an option that is none or that Pomona itself sets.
std::vector<std::string> array_submission(const FarmJob& job, const SlurmOptions& options,
                                          const std::filesystem::path& script);

/// The same for the merge, which begins when all tasks of the array have ended, however they did: it says what is
/// missing.
std::vector<std::string> merge_submission(const SlurmOptions& options, const std::string& array_job,
                                          const std::filesystem::path& script);

/// A script that submits both by hand, and notes their numbers in the file `jobs` as record_jobs() does.
std::string submit_script(const FarmJob& job, const SlurmOptions& options, const std::filesystem::path& folder);

}  // namespace pomona
