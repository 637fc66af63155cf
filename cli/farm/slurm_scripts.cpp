#include "cli/farm/slurm_scripts.h"

#include <array>
#include <string_view>

#include "generator/base/error.h"
#include "generator/base/shell_words.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

/// Runs the command until it ends in a way that another attempt does not change.
std::string with_retries(const std::string& command, int retries) {
  const std::string max = std::to_string(retries);
  return "attempt=0\n"
         "while :; do\n"
         "  " +
         command +
         "\n"
         "  status=$?\n"
         "  # 71: memory or threads did not suffice. 74: something could not be read or written. 75: another run has "
         "the lock, or a signal asked for an end.\n"
         "  # Above 128: killed. Whatever else it is, it would be the same again.\n"
         "  [ \"$status\" -eq 71 ] || [ \"$status\" -eq 74 ] || [ \"$status\" -eq 75 ] || [ \"$status\" -gt 128 ] || "
         "exit \"$status\"\n"
         "  [ \"$attempt\" -lt " +
         max +
         " ] || exit \"$status\"\n"
         "  attempt=$((attempt + 1))\n"
         "  echo \"ended with status $status; again in $((10 * attempt)) s, attempt $attempt of " +
         max +
         "\"\n"
         "  sleep $((10 * attempt))\n"
         "done\n";
}

/// The user's texts come after the first command, where Slurm reads no options (#SBATCH).
std::string script(const std::string& what, const FarmJob& job, const std::string& log, const std::string& rest) {
  return "#!/bin/sh\n# " + what + " Written by `pomona farm slurm`; Slurm keeps a copy of its own.\nset -u\n" + "cd " +
         shell_quoted(job.works_in) + " || exit 66\nexec >>" + log + " 2>&1\n" + rest;
}

/// Options of sbatch that Pomona sets itself; "wait" would block the submission of the merge.
constexpr std::array<std::string_view, 14> own_options = {
    "array", "dependency", "wrap",  "parsable", "output",  "error", "chdir",
    "input", "test-only",  "usage", "help",     "version", "wait",  "kill-on-invalid-dep"};

/// Refuses a word that is not one option, or is one of ours, also abbreviated as getopt allows.
void check_option(const std::string& word) {
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    throw Error(ExitStatus::usage, "--sbatch=" + word + ": " + why, hint);
  };
  if (!word.starts_with("--") || word.size() < 3 || word[2] == '=')
    refuse("this is no long option", "write it as one word: --sbatch=--partition=night");
  const std::string name = word.substr(2, word.find('=') - 2);
  for (const std::string_view own : own_options)
    if (own.starts_with(name)) refuse("pomona itself says --" + std::string(own), "leave it out");
}

std::vector<std::string> submission(const std::string& name, const std::string& order, const SlurmOptions& options,
                                    const fs::path& script) {
  std::vector<std::string> words = {"sbatch",    "--parsable",         "--requeue", "--job-name=" + name,
                                    "--chdir=/", "--output=/dev/null", order};
  for (const std::string& word : options.sbatch) {
    check_option(word);
    words.push_back(word);
  }
  words.insert(words.end(), {"--", script});
  return words;
}

}  // namespace

std::string shard_script(const FarmJob& job, const SlurmOptions& options, const fs::path& logs) {
  const std::string share = "\"$SLURM_ARRAY_TASK_ID/" + std::to_string(job.tasks) + "\"";
  return script("Task N of an array makes shard N of a batch.", job,
                shell_quoted(logs / "shard-") + "\"$SLURM_ARRAY_TASK_ID\".txt",
                with_retries(shard_command(job, share, "\"${SLURM_CPUS_PER_TASK:-1}\""), options.retries));
}

std::string merge_script(const FarmJob& job, const SlurmOptions& options, const fs::path& logs) {
  return script("Joins the shards of a batch.", job, shell_quoted(logs / "merge.txt"),
                with_retries(merge_command_line(job), options.retries));
}

std::vector<std::string> array_submission(const FarmJob& job, const SlurmOptions& options, const fs::path& script) {
  const std::string at_once = options.at_once > 0 ? "%" + std::to_string(options.at_once) : "";
  return submission("pomona-shards", "--array=1-" + std::to_string(job.tasks) + at_once, options, script);
}

std::vector<std::string> merge_submission(const SlurmOptions& options, const std::string& array_job,
                                          const fs::path& script) {
  return submission("pomona-merge", "--dependency=afterany:" + array_job, options, script);
}

std::string submit_script(const FarmJob& job, const SlurmOptions& options, const fs::path& folder) {
  // The number of the array is known only after its submission: the shell appends it to "afterany:".
  const std::string array = shell_line(array_submission(job, options, folder / "shard.sh"));
  std::string merge = shell_line(merge_submission(options, "@", folder / "merge.sh"));
  const std::string mark = "'--dependency=afterany:@'";
  merge.replace(merge.find(mark), mark.size(), "--dependency=afterany:\"$array\"");
  return "#!/bin/sh\n# Submits the shards of a batch to Slurm, and the merge that waits for them. Written by `pomona "
         "farm slurm`.\n"
         "set -eu\narray=$(" +
         array + ")\narray=${array%%;*}\nmerge=$(" + merge + ")\nmerge=${merge%%;*}\n" +
         "printf 'array %s\\nmerge %s\\n' \"$array\" \"$merge\" >" + shell_quoted(folder / "jobs") + "\n";
}

}  // namespace pomona
