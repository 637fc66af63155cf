#include "cli/batch/batch_run.h"

#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "cli/batch/assemble.h"
#include "cli/batch/run_batch.h"
#include "cli/batch/sizes.h"
#include "cli/batch/summary/report.h"
#include "cli/batch/update.h"
#include "cli/batch/wanted_batch.h"
#include "cli/deliver/outputs.h"
#include "cli/options/option_checks.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

bool holds_anything(const fs::path& folder) {
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (entry.path().filename() != ".pomona") return true;
  return false;
}

/// A folder that holds anything but this very batch is not touched; of an update, but this batch as it was.
void check_folder_of(const fs::path& folder, const std::string& record, const RunWords& words, const ItemWork& work,
                     const Shard& shard) {
  std::error_code failed;
  if (!fs::exists(folder, failed)) return check_folder_there(folder.has_filename() ? folder : folder.parent_path());
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    throw Error(ExitStatus::cannot_create, {{{folder.string(), 0, 0, {}}, why, hint}});
  };
  if (!fs::is_directory(folder, failed)) refuse("is no folder", "");

  // Another batch, or something else altogether. A shard that begins at the same time may write batch.json between two
  // looks, but nothing before it.
  std::string there = batch_record_in(folder);
  if (there.empty() && holds_anything(folder)) {
    there = batch_record_in(folder);
    if (there.empty()) refuse("is not empty, and holds no batch", "name a folder of its own");
  }
  if (there.empty()) return;
  if (words.update) return check_holds_no_other_name(folder, there, record);
  check_holds_no_other(folder, there, record);
  if (!words.resume && has_any_item(work, folder, shard))
    refuse("holds items of this batch already", "--resume keeps them and makes what is missing");
}

ExitStatus finish(const RunReport& report, const RunWords& words, Workplace& workplace, const Shard& shard,
                  Progress& progress) {
  if (shard.count == 1) assemble(workplace);
  if (words.json) std::printf("%s\n", report_as_json(report).c_str());
  progress.line(summary(report, workplace.folder().string()));
  if (shard.count > 1) progress.line("when all shards are done: pomona merge " + words.output);
  return report.failed.empty() ? ExitStatus::done : ExitStatus::some_items_failed;
}

}  // namespace

void check_run_words(const RunWords& words) {
  const Shard shard = parse_shard(words.shard);
  parse_memory(words.memory);
  if (words.update && shard.count > 1)
    throw Error(ExitStatus::usage, "--update has the folder alone: it does not go with --shard",
                "stop it once it has begun, and let shards go on with --resume");
}

ExitStatus made_in_folder(ItemWork& work, const RunOfItems& run, const RunWords& words) {
  const RunOptions options{.shard = run.only.value_or(parse_shard(words.shard)),
                           .threads = {words.threads},
                           .memory = parse_memory(words.memory),
                           .check = words.verify ? FileCheck::hashes : FileCheck::lengths};
  const fs::path folder = words.output;
  check_folder_of(folder, run.record, words, work, options.shard);

  // From here on the folder is ours, or a share of it; what it holds may have changed while we waited for it.
  Progress progress(words.quiet);
  for (const std::string& warning : run.warnings) progress.line("warning: " + warning);
  Workplace workplace(folder, options.shard);
  check_folder_of(folder, run.record, words, work, options.shard);
  const std::string there = batch_record_in(folder);
  if (words.update && !there.empty() && there != run.record)
    progress.line(told(update_folder(work, there, run.record, workplace)));
  if (there.empty()) workplace.put_file("batch.json", [&](const Workplace::Writer& write) { write(run.record); });
  return finish(run_batch(work, workplace, options, progress), words, workplace, options.shard, progress);
}

void add_run_options(CLI::App& command, RunWords& words) {
  command.add_option("-o,--output", words.output, "The folder to make them in; made if it is not there")
      ->type_name("FOLDER")
      ->check(folder_name())
      ->required();

  // Which of them, and how many at once.
  CLI::Option* resume = command.add_flag("--resume", words.resume, "Keep what is there, and make what is missing");
  CLI::Option* update =
      command.add_flag("--update", words.update,
                       "Keep what the files and the program as they are now would make the same, and make the rest");
  update->excludes(resume);
  command
      .add_flag("--verify", words.verify,
                "With --resume: read what is there, and make anew what is not as it was written")
      ->needs(resume);
  command.add_option("--shard", words.shard, "Make share I of N, from 1; `pomona merge` joins them")->type_name("I/N");
  command.add_option("--memory", words.memory, "What items under way may take together (2GB); no limit unless said")
      ->type_name("SIZE");
  command.add_option("--threads", words.threads, "Threads to use; 0 = all. The result does not depend on it")
      ->check(whole_between(0, 1024))
      ->capture_default_str();
  command.add_flag("--quiet", words.quiet, "Print nothing but errors");
  command.add_flag("--json", words.json, "Print the result as JSON");
}

}  // namespace pomona
