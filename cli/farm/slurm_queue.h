// Submits jobs to Slurm, and asks for their states.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/farm/farm_folder.h"

namespace pomona {

/// Submits with these words of array_submission() or merge_submission().
/// \return the job's number
/// \throws Error (helper_missing) if there is no sbatch, or if it refuses, with its message.
std::string submit(const std::vector<std::string>& sbatch);

/// The state of a job in the queue, or in the accounting after it has left: "RUNNING", "PENDING", "COMPLETED", ...
struct JobState {
  std::string state;
  std::string reason;   ///< why it waits: "Resources"; empty if it does not
  bool queued = false;  ///< still in the queue

  bool is_running() const { return queued && (state == "RUNNING" || state == "COMPLETING"); }
};

struct QueueState {
  std::map<int, JobState> shards;  ///< by the task's number, from 1
  JobState merge;
  std::string trouble;  ///< why the states are unknown; empty if the queue answered
};

/// Asks squeue, and sacct for jobs that have left the queue, if these programs exist.
QueueState queue_state(const QueuedJobs& jobs);

/// Reads lines "12_3|PENDING|Resources" of squeue and "12_3|FAILED|" of sacct; lines of other jobs are ignored.
/// Accounting never replaces what the queue says.
void take_lines(QueueState& queue, const QueuedJobs& jobs, const std::string& lines, bool queued);

}  // namespace pomona
