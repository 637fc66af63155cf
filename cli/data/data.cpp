// pomona data: a data set of pictures with exact ground truth, drawn from laws.
#include <filesystem>
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
#include "generator/base/beside.h"
#include "generator/base/error.h"
#include "generator/base/shell_words.h"
#include "generator/piece/piece_origin.h"

namespace pomona {

namespace {

struct DataCommand {
  std::string file;
  BackgroundPaths behind;
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

/// The set's words in commands that make its pictures again, typed where paths in them start.
std::string words_of(const DataCommand& command, const std::filesystem::path& file) {
  const std::filesystem::path start = start_of_commands(file);
  std::string words = shell_word(source_word((is_own_scene(file) ? file.stem() : file.filename()).string()));
  const auto add = [&](const char* flag, const std::vector<std::string>& paths) {
    for (const std::string& path : paths) words += flag + shell_word(source_word(word_from(start, path)));
  };
  add(" --background ", command.behind.pictures);
  add(" --environment ", command.behind.environments);
  return words;
}

ExitStatus make_data(const DataCommand& command) {
  // Everything that can be wrong with the words and the file is told before anything is written.
  check_run_words(command.run);
  if (command.picture && (!command.run.shard.empty() || command.run.update))
    throw Error(ExitStatus::usage, "--picture makes one alone: it does not go with --shard or --update");
  const std::filesystem::path file = find_file("scenes", command.file, "data set");
  const DataPlan plan = wanted_data(file, command.behind);
  PictureWork work(plan, words_of(command, file));
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
  command
      ->add_option("--background", options->behind.pictures,
                   "A .png to stand behind, or a folder of these, in place of those that the file names")
      ->allow_extra_args(false);
  command
      ->add_option("--environment", options->behind.environments,
                   "The same with pictures of all directions (.png, .hdr), twice as wide as high, which light the "
                   "things, too")
      ->allow_extra_args(false);
  add_run_options(*command, options->run);
  return {command, [options] { return make_data(*options); }};
}

}  // namespace pomona
