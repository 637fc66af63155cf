// pomona batch: many items, each a folder of files; a batch in shards is put together by merge.cpp.
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/batch/asset_work.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/wanted_batch.h"
#include "cli/command.h"
#include "cli/options/program_folders.h"

namespace pomona {

namespace {

struct BatchCommand {
  std::string batch;
  RunWords run;
};

ExitStatus make_batch(const BatchCommand& command) {
  // Everything that can be wrong with the words and the file is told before anything is written.
  check_run_words(command.run);
  const BatchPlan plan = wanted_batch(find_file("scenes", command.batch, "batch"));
  AssetWork work(plan, styles_of(plan));
  return made_in_folder(work, {.record = record_of(plan), .warnings = batch_warnings(plan)}, command.run);
}

}  // namespace

DeclaredCommand batch_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("batch", "Make many assets: a folder each, a manifest, a contact sheet");
  const auto options = std::make_shared<BatchCommand>();
  command->add_option("BATCH", options->batch, "A name from `pomona list --batches`, or a batch file (.toml)")
      ->required();
  add_run_options(*command, options->run);
  return {command, [options] { return make_batch(*options); }};
}

}  // namespace pomona
