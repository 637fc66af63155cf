// pomona data: a data set of pictures with exact ground truth, drawn from laws.
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/batch/batch_run.h"
#include "cli/command.h"
#include "cli/data/picture_work.h"
#include "cli/data/wanted_data.h"
#include "cli/options/option_checks.h"
#include "cli/options/program_folders.h"
#include "generator/base/error.h"

namespace pomona {

namespace {

struct DataCommand {
  std::string file;
  std::optional<int> picture;
  RunWords run;
};

/// One picture is a share of its own.
std::optional<Shard> share_of(const DataCommand& command, const DataPlan& plan) {
  if (!command.picture) return {};
  if (*command.picture >= plan.data.count)
    throw Error(ExitStatus::usage, "--picture " + std::to_string(*command.picture) + " is none of the set",
                "its pictures have the numbers 0 to " + std::to_string(plan.data.count - 1));
  return Shard{*command.picture + 1, plan.data.count};
}

ExitStatus make_data(const DataCommand& command) {
  // Everything that can be wrong with the words and the file is told before anything is written.
  check_run_words(command.run);
  if (command.picture && (!command.run.shard.empty() || command.run.update))
    throw Error(ExitStatus::usage, "--picture makes one alone: it does not go with --shard or --update");
  const DataPlan plan = wanted_data(find_file("scenes", command.file, "data set"));
  PictureWork work(plan, command.file);
  return made_in_folder(work, {.record = record_of(plan), .only = share_of(command, plan)}, command.run);
}

}  // namespace

DeclaredCommand data_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("data", "Make a data set: pictures drawn from laws, with exact ground truth");
  const auto options = std::make_shared<DataCommand>();
  command->add_option("FILE", options->file, "A data set file (.toml), or its name among the program's scenes")
      ->required();
  command->add_option("--picture", options->picture, "Make the picture of this number alone")
      ->check(whole_between(0, max_data_pictures - 1));
  add_run_options(*command, options->run);
  return {command, [options] { return make_data(*options); }};
}

}  // namespace pomona
