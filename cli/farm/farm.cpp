// pomona farm: a batch on many machines, by Slurm or by commands for other farms.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/batch/assemble.h"
#include "cli/batch/sizes.h"
#include "cli/batch/wanted_batch.h"
#include "cli/command.h"
#include "cli/data/wanted_data.h"
#include "cli/farm/farm_folder.h"
#include "cli/farm/farm_job.h"
#include "cli/farm/farm_status.h"
#include "cli/farm/slurm_queue.h"
#include "cli/farm/slurm_scripts.h"
#include "cli/options/option_checks.h"
#include "cli/options/program_folders.h"
#include "generator/base/error.h"
#include "generator/base/shell_words.h"
#include "generator/data/data_file.h"
#include "render/export/output.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

struct JobOptions {
  std::string batch, output, memory, program;
  int tasks = 64;
};

struct SlurmCommand : JobOptions {
  SlurmOptions slurm;
  bool dry_run = false;
};

struct LinesCommand : JobOptions {
  int threads = 1;
  bool for_opencue = false;
};

struct StatusCommand {
  std::string folder;
  int tasks = 0, threads = 0;
  bool json = false;
};

/// The path as all machines of the farm know it.
fs::path normal(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Reports once what each task would report: a bad batch, another batch's folder.
FarmJob job_for(const JobOptions& options) {
  parse_memory(options.memory);
  const fs::path file = normal(find_file("scenes", options.batch, "batch"));
  const bool is_data = is_data_file(file);
  const FarmJob job{.program = options.program.empty() ? this_program() : fs::path(options.program),
                    .batch = file,
                    .makes = is_data ? "data" : "batch",
                    .output = normal(options.output),
                    .works_in = fs::current_path(),
                    .tasks = options.tasks,
                    .memory = options.memory};
  const std::string wanted = is_data ? record_of(wanted_data(file)) : record_of(wanted_batch(file));
  check_holds_no_other(job.output, batch_record_in(job.output), wanted);
  return job;
}

/// Two arrays of the same shards would only lock each other out.
void check_not_queued(const fs::path& output) {
  const auto before = read_farm(output);
  if (!before) return;
  const QueueState queue = queue_state(before->jobs);
  bool queued = queue.merge.queued;
  for (const auto& [shard, job] : queue.shards) queued = queued || job.queued;
  if (queued)
    throw Error(ExitStatus::locked, {{{output.string(), 0, 0, {}},
                                      "is in the queue already, as job " + before->jobs.array,
                                      "pomona farm status tells how far it is; scancel takes it off"}});
}

/// Submits the array, then the merge that waits for it, and records each at once.
QueuedJobs submit_both(const FarmJob& job, const SlurmOptions& options, const fs::path& folder) {
  QueuedJobs jobs;
  try {
    jobs.array = submit(array_submission(job, options, folder / "shard.sh"));
  } catch (const Error& error) {
    if (!error.diagnostics().front().hint.empty()) throw;
    throw Error(
        error.status(), error.diagnostics().front().message,
        "the scripts are kept: when that is mended, sh " + shell_quoted(folder / "submit.sh") + " submits them");
  }
  record_jobs(folder, jobs);
  try {
    jobs.merge = submit(merge_submission(options, jobs.array, folder / "merge.sh"));
  } catch (const Error& error) {
    throw Error(
        error.status(),
        "job " + jobs.array + " makes the shards, but no merge waits for it: " + error.diagnostics().front().message,
        "when it is done: pomona merge " + job.output.string());
  }
  record_jobs(folder, jobs);
  return jobs;
}

ExitStatus give_to_slurm(const SlurmCommand& command) {
  // Checks everything before anything is written.
  const FarmJob job = job_for(command);
  const fs::path folder = farm_folder(job.output), logs = folder / "logs";
  const std::vector<OutputFile> scripts = {{folder / "shard.sh", shard_script(job, command.slurm, logs)},
                                           {folder / "merge.sh", merge_script(job, command.slurm, logs)},
                                           {folder / "submit.sh", submit_script(job, command.slurm, folder)}};
  check_not_queued(job.output);

  // Forgets the numbers of an earlier submission.
  record_farm(job);
  write_whole(scripts);
  std::error_code ignored;
  fs::remove(folder / "jobs", ignored);
  if (command.dry_run) {
    std::printf("sh %s submits them\n", shell_quoted(folder / "submit.sh").c_str());
    return ExitStatus::done;
  }
  const QueuedJobs jobs = submit_both(job, command.slurm, folder);
  std::printf("job %s: %d tasks; job %s merges them\n", jobs.array.c_str(), job.tasks, jobs.merge.c_str());
  return ExitStatus::done;
}

ExitStatus print_lines(const LinesCommand& command) {
  const std::string threads = command.for_opencue ? "\"${CUE_THREADS:-1}\"" : std::to_string(command.threads);
  for (const std::string& line : shard_lines(job_for(command), threads)) std::printf("%s\n", line.c_str());
  return ExitStatus::done;
}

ExitStatus print_status(const StatusCommand& command) {
  const fs::path folder = normal(command.folder);
  const auto farm = read_farm(folder);
  if (!farm && batch_record_in(folder).empty())
    throw Error(ExitStatus::input_missing,
                {{{command.folder, 0, 0, {}}, "holds no batch, and none is in a queue for it", {}}});

  // The number of shards is known from a submission to Slurm; otherwise all items count together.
  const int tasks = command.tasks > 0 ? command.tasks : farm ? farm->tasks : 1;
  FarmStatus status{folder, progress_of(folder, tasks, {command.threads}), farm ? farm->jobs : QueuedJobs{}, {}};
  status.queue = queue_state(status.jobs);
  if (!status.queue.trouble.empty()) std::fprintf(stderr, "the queue is not known: %s\n", status.queue.trouble.c_str());
  std::printf("%s", command.json ? (as_json(status) + "\n").c_str() : as_table(status).c_str());
  return status.is_complete() ? ExitStatus::done : ExitStatus::some_items_failed;
}

void declare_job(CLI::App& command, JobOptions& options) {
  command
      .add_option("BATCH", options.batch,
                  "A name from `pomona list --batches`, or a file of a batch or data set (.toml)")
      ->required();
  command.add_option("-o,--output", options.output, "The folder to make the batch in, for all machines the same")
      ->type_name("FOLDER")
      ->check(folder_name())
      ->required();
  command.add_option("--tasks", options.tasks, "Shards to make of it")
      ->check(whole_between(1, max_shards))
      ->capture_default_str();
  command.add_option("--memory", options.memory, "What items under way in a task may take together (2GB)")
      ->type_name("SIZE");
  command.add_option("--program", options.program, "Where pomona lies on the farm; where this one lies unless said")
      ->type_name("FILE");
}

std::function<ExitStatus()> declare_slurm(CLI::App& command) {
  const auto options = std::make_shared<SlurmCommand>();
  declare_job(command, *options);
  command.add_flag("--dry-run", options->dry_run, "Write the scripts, and submit nothing");
  command.add_option("--at-once", options->slurm.at_once, "Most tasks that run at a time; 0 = as many as Slurm likes")
      ->check(whole_between(0, max_shards))
      ->capture_default_str();
  command.add_option("--retries", options->slurm.retries, "How often a task that was disturbed tries again by itself")
      ->check(whole_between(0, 100))
      ->capture_default_str();
  command.add_option("--sbatch", options->slurm.sbatch, "A further option for sbatch: --sbatch=--partition=night")
      ->type_name("OPTION")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->expected(1);
  return [options] { return give_to_slurm(*options); };
}

std::function<ExitStatus()> declare_lines(CLI::App& command) {
  const auto options = std::make_shared<LinesCommand>();
  declare_job(command, *options);
  CLI::Option* threads = command.add_option("--threads", options->threads, "Threads of each command; 0 = all")
                             ->check(whole_between(0, 1024))
                             ->capture_default_str();
  command.add_flag("--opencue", options->for_opencue, "Take as many threads as OpenCue gives the frame")
      ->excludes(threads);
  return [options] { return print_lines(*options); };
}

std::function<ExitStatus()> declare_status(CLI::App& command) {
  const auto options = std::make_shared<StatusCommand>();
  command.add_option("FOLDER", options->folder, "The folder that the batch is made in")->required();
  command.add_option("--tasks", options->tasks, "Shards it is made in; what Slurm was given unless said")
      ->check(whole_between(1, max_shards));
  command.add_option("--threads", options->threads, "Threads to read with; 0 = all")
      ->check(whole_between(0, 1024))
      ->capture_default_str();
  command.add_flag("--json", options->json, "Print it as JSON");
  return [options] { return print_status(*options); };
}

}  // namespace

DeclaredCommand farm_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("farm", "Make a batch on many machines: Slurm, or any list of commands");
  command->require_subcommand(1);
  CLI::App* slurm = command->add_subcommand("slurm", "Write and submit a job array that makes shards, and their merge");
  CLI::App* lines = command->add_subcommand("commands", "Print a command for each shard");
  CLI::App* status = command->add_subcommand("status", "Tell how far shards are, in the folder and in Slurm's queue");

  // One of the subcommands has been typed.
  const std::vector<DeclaredCommand> parts = {
      {slurm, declare_slurm(*slurm)}, {lines, declare_lines(*lines)}, {status, declare_status(*status)}};
  return {command, [parts] {
            for (const DeclaredCommand& part : parts)
              if (part.subcommand->parsed()) return part.action();
            return ExitStatus::usage;
          }};
}

}  // namespace pomona
