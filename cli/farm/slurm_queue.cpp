#include "cli/farm/slurm_queue.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "cli/farm/run_words.h"
#include "generator/base/error.h"

namespace pomona {

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The digits at the beginning: sbatch writes "12" or "12;cluster".
std::string leading_number(const std::string& text) {
  const auto end = std::find_if(text.begin(), text.end(), [](char c) { return c < '0' || c > '9'; });
  return {text.begin(), end};
}

/// The text up to the next '|', which is removed, too.
std::string next_field(std::string& line) {
  const std::size_t bar = std::min(line.find('|'), line.size());
  const std::string field = line.substr(0, bar);
  line.erase(0, bar + 1);
  return field;
}

std::string both(const QueuedJobs& jobs) { return jobs.array + (jobs.merge.empty() ? "" : "," + jobs.merge); }

/// Nothing if there is no such program, or no output.
ProgramOutcome asked(const std::vector<std::string>& words) {
  try {
    return run_words(words);
  } catch (const Error& error) {
    return {127, {}, error.diagnostics().front().message};
  }
}

}  // namespace

std::string submit(const std::vector<std::string>& sbatch) {
  const ProgramOutcome outcome = run_words(sbatch);
  const std::string job = leading_number(outcome.out);
  if (outcome.status == 0 && !job.empty()) return job;
  if (outcome.status == 0) {
    throw Error(ExitStatus::helper_missing, "sbatch tells no job's number: " + first_line(outcome.out),
                "squeue --me shows whether it has taken the job");
  }
  throw Error(ExitStatus::helper_missing, "sbatch has refused: " + first_line(outcome.err));
}

void take_lines(QueueState& queue, const QueuedJobs& jobs, const std::string& lines, bool queued) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    // The merge has a number of its own.
    const std::string id = next_field(line);
    JobState state{.state = next_field(line), .reason = next_field(line), .queued = queued};
    if (state.reason == "None") state.reason.clear();
    if (id == jobs.merge) {
      if (!queue.merge.queued) queue.merge = state;
      continue;
    }

    // A task of the array; with --array, tasks that wait together ("12_[3-64]") have lines of their own.
    if (!id.starts_with(jobs.array + "_")) continue;
    const std::string task = id.substr(jobs.array.size() + 1);
    int shard = 0;
    const auto [end, error] = std::from_chars(task.data(), task.data() + task.size(), shard);
    if (error != std::errc() || end != task.data() + task.size()) continue;
    queue.shards.emplace(shard, state);
  }
}

QueueState queue_state(const QueuedJobs& jobs) {
  QueueState queue;
  if (jobs.array.empty()) return queue;
  const ProgramOutcome squeue = asked({"squeue", "--noheader", "--array", "--jobs=" + both(jobs), "--format=%i|%T|%r"});
  take_lines(queue, jobs, squeue.out, true);

  // A queue that has forgotten the job reports an error, which counts as an answer.
  const bool has_forgotten = squeue.err.find("Invalid job id") != std::string::npos;
  if (squeue.status != 0 && !has_forgotten) queue.trouble = first_line(squeue.err);
  const ProgramOutcome sacct =
      asked({"sacct", "--noheader", "--parsable2", "--allocations", "--jobs=" + both(jobs), "--format=JobID,State"});
  if (sacct.status == 0) take_lines(queue, jobs, sacct.out, false);
  return queue;
}

}  // namespace pomona
