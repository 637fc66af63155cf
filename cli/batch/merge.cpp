// pomona merge: joins the shards of a batch.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/batch/assemble.h"
#include "cli/command.h"
#include "cli/deliver/progress.h"
#include "generator/base/json_text.h"

namespace pomona {

namespace {

struct MergeCommand {
  std::string folder;
  bool quiet = false, json = false;
};

void print_json(const AssembleReport& report) {
  nlohmann::ordered_json json = {{"items", report.items},
                                 {"missing", report.missing},
                                 {"first_missing", report.first_missing},
                                 {"failed", nlohmann::ordered_json::array()}};
  for (const FailedItem& failed : report.failed)
    json["failed"].push_back({{"item", failed.item}, {"reason", failed.reason}});
  std::printf("%s\n", json_text(json, 2).c_str());
}

ExitStatus merge(const MergeCommand& command) {
  if (batch_record_in(command.folder).empty())
    throw Error(
        ExitStatus::input_missing,
        {{{command.folder, 0, 0, {}}, "holds no batch", "pomona batch makes one: its folder has a batch.json"}});

  // Hold the folder alone.
  Progress progress(command.quiet);
  Workplace workplace(command.folder, {});
  const AssembleReport report = assemble(workplace);
  if (command.json) print_json(report);

  // Report missing and failed items.
  for (const std::string& item : report.first_missing) progress.error(item + ": error: missing");
  const auto named = static_cast<std::int64_t>(report.first_missing.size());
  if (report.missing > named) progress.error("and " + std::to_string(report.missing - named) + " more");
  for (const FailedItem& failed : report.failed) progress.error(failed.item + ": error: " + failed.reason);
  if (report.missing > 0) {
    progress.line(std::to_string(report.missing) + " of " + std::to_string(report.items) +
                  " items are missing: run their shards with --resume, or all with `pomona batch --resume`");
  } else {
    progress.line(command.folder + ": " + std::to_string(report.items) + " items");
  }
  return report.missing == 0 && report.failed.empty() ? ExitStatus::done : ExitStatus::some_items_failed;
}

}  // namespace

DeclaredCommand merge_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("merge", "Make one batch of what its shards have left");
  const auto options = std::make_shared<MergeCommand>();
  command->add_option("FOLDER", options->folder, "The folder that `pomona batch --shard` wrote to")->required();
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->add_flag("--json", options->json, "Print the result as JSON");
  return {command, [options] { return merge(*options); }};
}

}  // namespace pomona
