// FOLDER.farm, beside a batch's FOLDER: scripts, logs, and the jobs of a queue. It is not part of the batch.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/farm/farm_job.h"

namespace pomona {

/// "out/many" -> "out/many.farm".
std::filesystem::path farm_folder(const std::filesystem::path& output);

/// The numbers of jobs in a queue; empty if there is none.
struct QueuedJobs {
  std::string array, merge;
};

/// The record of a submission.
struct FarmRecord {
  int tasks = 0;
  QueuedJobs jobs;
};

/// Makes the folder and its folder of logs, and writes farm.json into it.
/// \throws Error (cannot_create, io_error)
void record_farm(const FarmJob& job);

/// Writes the file `jobs`: a line "array 12", a line "merge 13".
/// \throws Error (cannot_create, io_error)
void record_jobs(const std::filesystem::path& folder, const QueuedJobs& jobs);

/// Nothing if the batch's folder has none beside it.
/// \throws Error (bad_data) if what is there cannot be read.
std::optional<FarmRecord> read_farm(const std::filesystem::path& output);

}  // namespace pomona
