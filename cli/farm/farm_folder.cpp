#include "cli/farm/farm_folder.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "cli/batch/sizes.h"
#include "generator/base/error.h"
#include "generator/base/first_bytes.h"
#include "generator/base/json_text.h"
#include "generator/text/json_node.h"
#include "render/export/output.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::size_t longest_record = std::size_t{1} << 20;  // bytes

/// Empty if there is no such file; longer texts than any record are cut off, so that the reader finds a mistake.
std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return first_bytes(stream, longest_record);
}

[[noreturn]] void fail(const fs::path& file, const std::string& message) {
  throw Error(ExitStatus::bad_data, {{{file.string(), 0, 0, {}}, message, "pomona farm slurm writes it again"}});
}

bool is_number(const std::string& text) {
  return !text.empty() && text.size() < 20 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

QueuedJobs read_jobs(const fs::path& file) {
  QueuedJobs jobs;
  std::ifstream stream(file);
  for (std::string what, number; stream >> what >> number;) {
    if (!is_number(number)) fail(file, "should have a job's number after \"" + what.substr(0, 20) + "\"");
    if (what == "array") jobs.array = number;
    if (what == "merge") jobs.merge = number;
  }
  return jobs;
}

}  // namespace

fs::path farm_folder(const fs::path& output) {
  fs::path folder = output.has_filename() ? output : output.parent_path();
  return folder += ".farm";
}

void record_farm(const FarmJob& job) {
  const fs::path folder = farm_folder(job.output);
  std::error_code failed;
  fs::create_directories(folder / "logs", failed);
  if (failed)
    throw Error(ExitStatus::cannot_create,
                {{{(folder / "logs").string(), 0, 0, {}}, "cannot be created: " + failed.message(), {}}});
  const nlohmann::ordered_json record = {
      {"format", 1}, {"tasks", job.tasks}, {"batch", job.batch.string()}, {"folder", job.output.string()}};
  write_whole(folder / "farm.json", json_text(record, 1) + "\n");
}

void record_jobs(const fs::path& folder, const QueuedJobs& jobs) {
  std::string text = "array " + jobs.array + "\n";
  if (!jobs.merge.empty()) text += "merge " + jobs.merge + "\n";
  write_whole(folder / "jobs", text);
}

std::optional<FarmRecord> read_farm(const fs::path& output) {
  const fs::path file = farm_folder(output) / "farm.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  const JsonNode root = parse_json(text_of(file), file.string());
  const JsonNode& tasks = root.need("tasks");
  const bool is_whole = tasks.kind == JsonNode::Kind::number && tasks.number >= 1 && tasks.number <= max_shards &&
                        tasks.number == static_cast<int>(tasks.number);
  if (!is_whole) fail(file, "should say how many tasks there are");
  return FarmRecord{static_cast<int>(tasks.number), read_jobs(farm_folder(output) / "jobs")};
}

}  // namespace pomona
