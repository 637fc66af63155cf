#include "cli/farm/farm_status.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "generator/base/json_text.h"

namespace pomona {

namespace {

ShardProgress total_of(const BatchProgress& batch) {
  ShardProgress total;
  for (const ShardProgress& shard : batch.shards) {
    total.items += shard.items;
    total.done += shard.done;
    total.failed += shard.failed;
  }
  return total;
}

JobState job_of(const FarmStatus& status, int shard) {
  const auto found = status.queue.shards.find(shard);
  return found == status.queue.shards.end() ? JobState{} : found->second;
}

/// "PENDING (Resources)"; a dash if nothing is known.
std::string text_of(const JobState& job) {
  if (job.state.empty()) return "-";
  return job.state + (job.reason.empty() ? "" : " (" + job.reason + ")");
}

std::string merge_state(const FarmStatus& status) {
  if (status.queue.merge.is_running()) return "running";
  if (status.queue.merge.queued) return "waiting";
  return status.batch.merged ? "done" : "missing";
}

std::string line_of(const std::string& what, const std::string& state, const ShardProgress& shard,
                    const std::string& queue) {
  char line[160];
  std::snprintf(line, sizeof line, "%7s  %-8s %9lld %9lld %9lld  ", what.c_str(), state.c_str(),
                static_cast<long long>(shard.done), static_cast<long long>(shard.failed),
                static_cast<long long>(shard.missing()));
  return line + queue + "\n";
}

}  // namespace

bool FarmStatus::is_complete() const {
  const ShardProgress total = total_of(batch);
  return batch.merged && total.items > 0 && total.done == total.items;
}

std::string shard_state(const FarmStatus& status, int shard) {
  const ShardProgress& there = status.batch.shards[static_cast<std::size_t>(shard - 1)];
  const JobState job = job_of(status, shard);
  if (there.at_work || job.is_running()) return "running";
  if (job.queued) return "waiting";
  if (there.begun) return "stopped";
  if (there.missing() > 0 || status.batch.name.empty()) return "missing";
  return there.failed > 0 ? "failed" : "done";
}

std::string as_table(const FarmStatus& status) {
  std::string table = "  shard  state         done    failed   missing  slurm\n";
  const int shards = static_cast<int>(status.batch.shards.size());
  for (int shard = 1; shard <= shards; ++shard) {
    table += line_of(std::to_string(shard), shard_state(status, shard),
                     status.batch.shards[static_cast<std::size_t>(shard - 1)], text_of(job_of(status, shard)));
  }
  table += line_of("all", "", total_of(status.batch), "-");
  return table + "merge: " + merge_state(status) +
         (status.queue.merge.state.empty() ? "" : ", " + text_of(status.queue.merge)) + "\n";
}

std::string as_json(const FarmStatus& status) {
  // All together.
  const ShardProgress total = total_of(status.batch);
  nlohmann::ordered_json json = {{"folder", status.folder.string()},
                                 {"batch", status.batch.name},
                                 {"items", total.items},
                                 {"done", total.done},
                                 {"failed", total.failed},
                                 {"missing", total.missing()},
                                 {"merge", merge_state(status)},
                                 {"complete", status.is_complete()}};
  json["jobs"] = {{"array", status.jobs.array}, {"merge", status.jobs.merge}};
  if (!status.queue.trouble.empty()) json["trouble"] = status.queue.trouble;

  // Shard by shard.
  json["shards"] = nlohmann::ordered_json::array();
  for (int shard = 1; shard <= static_cast<int>(status.batch.shards.size()); ++shard) {
    const ShardProgress& there = status.batch.shards[static_cast<std::size_t>(shard - 1)];
    const JobState job = job_of(status, shard);
    json["shards"].push_back({{"shard", shard},
                              {"state", shard_state(status, shard)},
                              {"items", there.items},
                              {"done", there.done},
                              {"failed", there.failed},
                              {"missing", there.missing()},
                              {"slurm", job.state},
                              {"reason", job.reason}});
  }
  return json_text(json, 2);
}

}  // namespace pomona
