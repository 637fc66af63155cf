#include "cli/farm/farm_job.h"

#include "generator/base/error.h"
#include "generator/base/shell_words.h"

namespace pomona {

namespace {

/// Line breaks of Unix and, for readers that know them, all others of ASCII.
void check_fits_a_line(const std::filesystem::path& path) {
  if (path.native().find_first_of("\n\r\v\f") == std::string::npos) return;
  throw Error(ExitStatus::usage, "\"" + path.string() + "\" has a line break, and a command must stand on one line",
              "rename it, or write a Slurm script: pomona farm slurm --dry-run");
}

}  // namespace

std::string shard_command(const FarmJob& job, const std::string& share, const std::string& threads) {
  const std::string words[] = {job.program, job.makes, job.batch, "-o", job.output};
  std::string command = shell_line(words) + " --shard " + share + " --resume --threads " + threads;
  if (!job.memory.empty()) command += " --memory " + shell_quoted(job.memory);
  return command;
}

std::string merge_command_line(const FarmJob& job) {
  const std::string words[] = {job.program, "merge", job.output};
  return shell_line(words);
}

std::vector<std::string> shard_lines(const FarmJob& job, const std::string& threads) {
  for (const auto& path : {job.program, job.batch, job.output, job.works_in}) check_fits_a_line(path);
  const std::string goes_there = "cd " + shell_quoted(job.works_in) + " && ";
  std::vector<std::string> lines;
  for (int shard = 1; shard <= job.tasks; ++shard) {
    const std::string share = std::to_string(shard) + "/" + std::to_string(job.tasks);
    lines.push_back(goes_there + shard_command(job, share, threads));
  }
  return lines;
}

}  // namespace pomona
