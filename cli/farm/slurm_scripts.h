// The input for Slurm: a script for the tasks of an array, one for the merge that waits for them, and the arguments of
// sbatch.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/farm/farm_job.h"

namespace pomona {

struct SlurmOptions {
  int at_once = 0;                  ///< maximum number of tasks that run at a time; 0 = no limit
  int retries = 2;                  ///< how often a task tries again
  std::vector<std::string> sbatch;  ///< further options of sbatch: "--partition=night"
};

/// Task N makes shard N and writes LOGS/shard-N.txt. After status 74 or 75, or a signal, it tries again after 10 s, 20
/// s, ...; every other status is the task's.
std::string shard_script(const FarmJob& job, const SlurmOptions& options, const std::filesystem::path& logs);

/// The script of the merge, which writes LOGS/merge.txt.
std::string merge_script(const FarmJob& job, const SlurmOptions& options, const std::filesystem::path& logs);

/// sbatch and its arguments. The only path is the script's, because sbatch interprets '%' and '\' in paths.
/// \throws Error (usage) for an invalid option, or one that Pomona sets itself.
std::vector<std::string> array_submission(const FarmJob& job, const SlurmOptions& options,
                                          const std::filesystem::path& script);

/// The same for the merge, which starts when all tasks of the array have ended, with any status: it names missing
/// items.
std::vector<std::string> merge_submission(const SlurmOptions& options, const std::string& array_job,
                                          const std::filesystem::path& script);

/// A script to submit both by hand; it writes their numbers into the file `jobs` like record_jobs().
std::string submit_script(const FarmJob& job, const SlurmOptions& options, const std::filesystem::path& folder);

}  // namespace pomona
