// pomona batch: many items, each a folder of files; merge.cpp joins the shards of a batch.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/batch/assemble.h"
#include "cli/batch/report.h"
#include "cli/batch/run_batch.h"
#include "cli/batch/sizes.h"
#include "cli/batch/wanted_batch.h"
#include "cli/command.h"
#include "cli/options/option_checks.h"
#include "cli/options/program_folders.h"
#include "generator/base/error.h"
#include "render/style/style_file.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

struct BatchCommand {
  std::string batch, output, shard, memory;
  bool resume = false, verify = false, quiet = false, json = false;
  int threads = 0;
};

bool holds_anything(const fs::path& folder) {
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (entry.path().filename() != ".pomona") return true;
  return false;
}

/// Refuses a folder that holds anything but this batch.
void check_folder_of(const fs::path& folder, const std::string& record, bool resume, const BatchPlan& plan,
                     const Shard& shard) {
  std::error_code failed;
  if (!fs::exists(folder, failed)) return;
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    throw Error(ExitStatus::cannot_create, {{{folder.string(), 0, 0, {}}, why, hint}});
  };
  if (!fs::is_directory(folder, failed)) refuse("is no folder", "");

  // The folder holds another batch, or other files. A shard that starts at the same time may write batch.json between
  // two checks, but nothing before it.
  std::string there = batch_record_in(folder);
  if (there.empty() && holds_anything(folder)) {
    there = batch_record_in(folder);
    if (there.empty()) refuse("is not empty, and holds no batch", "name a folder of its own");
  }
  if (there.empty()) return;
  check_holds_no_other(folder, there, record);
  if (!resume && has_any_item(plan, folder, shard))
    refuse("holds items of this batch already", "--resume keeps them and makes what is missing");
}

ExitStatus finish(const RunReport& report, const BatchCommand& command, Workplace& workplace, const Shard& shard,
                  Progress& progress) {
  if (shard.count == 1) assemble(workplace);
  if (command.json) std::printf("%s\n", report_as_json(report).c_str());
  progress.line(summary(report, workplace.folder().string()));
  if (shard.count > 1) progress.line("when all shards are done: pomona merge " + command.output);
  return report.failed.empty() ? ExitStatus::done : ExitStatus::some_items_failed;
}

ExitStatus make_batch(const BatchCommand& command) {
  // Find all errors of the command line and the file before anything is written.
  const RunOptions options{.shard = parse_shard(command.shard),
                           .threads = {command.threads},
                           .memory = parse_memory(command.memory),
                           .check = command.verify ? FileCheck::hashes : FileCheck::lengths};
  const BatchPlan plan = wanted_batch(find_file("scenes", command.batch, "batch"));
  const std::vector<EntryStyles> styles = styles_of(plan);
  const std::string record = record_of(plan);
  const fs::path folder = command.output;
  check_folder_of(folder, record, command.resume, plan, options.shard);

  // From here on this run holds the folder, or a share of it. Its contents may have changed while we waited for the
  // lock.
  Progress progress(command.quiet);
  for (const std::string& warning : batch_warnings(plan)) progress.line("warning: " + warning);
  Workplace workplace(folder, options.shard);
  check_folder_of(folder, record, command.resume, plan, options.shard);
  if (batch_record_in(folder).empty())
    workplace.put_file("batch.json", [&](const Workplace::Writer& write) { write(record); });
  const RunReport report = run_batch(plan, styles, workplace, options, progress);
  return finish(report, command, workplace, options.shard, progress);
}

}  // namespace

DeclaredCommand batch_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("batch", "Make many assets: a folder each, a manifest, a contact sheet");
  const auto options = std::make_shared<BatchCommand>();
  command->add_option("BATCH", options->batch, "A name from `pomona list --batches`, or a batch file (.toml)")
      ->required();
  command->add_option("-o,--output", options->output, "The folder to make them in; made if it is not there")
      ->type_name("FOLDER")
      ->required();

  // Which items, and how many at once.
  CLI::Option* resume = command->add_flag("--resume", options->resume, "Keep what is there, and make what is missing");
  command
      ->add_flag("--verify", options->verify,
                 "With --resume: read what is there, and make anew what is not as it was written")
      ->needs(resume);
  command->add_option("--shard", options->shard, "Make share I of N, from 1; `pomona merge` joins them")
      ->type_name("I/N");
  command->add_option("--memory", options->memory, "What items under way may take together (2GB); no limit unless said")
      ->type_name("SIZE");
  command->add_option("--threads", options->threads, "Threads to use; 0 = all. The result does not depend on it")
      ->check(whole_between(0, 1024))
      ->capture_default_str();
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->add_flag("--json", options->json, "Print the result as JSON");
  return {command, [options] { return make_batch(*options); }};
}

}  // namespace pomona
