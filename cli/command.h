// Commands, and how the program runs them.
#pragma once

#include <functional>
#include <vector>

#include "generator/base/error.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

/// Declares a subcommand and its options on `app`; the returned action runs it once the line is parsed. The action
/// registers itself at `subcommand`, so that the program knows which command was typed.
struct DeclaredCommand {
  CLI::App* subcommand = nullptr;
  std::function<ExitStatus()> action;
};
using Command = DeclaredCommand (*)(CLI::App& app);

DeclaredCommand list_command(CLI::App& app);
DeclaredCommand check_command(CLI::App& app);
DeclaredCommand sketch_command(CLI::App& app);
DeclaredCommand grow_command(CLI::App& app);
DeclaredCommand cut_command(CLI::App& app);
DeclaredCommand plate_command(CLI::App& app);
DeclaredCommand scene_command(CLI::App& app);
DeclaredCommand batch_command(CLI::App& app);
DeclaredCommand data_command(CLI::App& app);
DeclaredCommand merge_command(CLI::App& app);
DeclaredCommand farm_command(CLI::App& app);
DeclaredCommand compare_command(CLI::App& app);
DeclaredCommand verify_command(CLI::App& app);
DeclaredCommand studio_command(CLI::App& app);
DeclaredCommand pages_command(CLI::App& app);

/// Runs an action and prints its errors.
ExitStatus run_action(const std::function<ExitStatus()>& action);

/// Parses the line, runs the command, prints errors, and returns the exit status.
int run(const std::vector<Command>& commands, int argc, char** argv);

}  // namespace pomona
