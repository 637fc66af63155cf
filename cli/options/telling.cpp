#include "cli/options/telling.h"

#include <CLI/CLI.hpp>

namespace pomona {

void add_telling_options(CLI::App& command, Telling& telling) {
  command.add_option("--stats", telling.stats, "Write times and counts to this JSON file")->type_name("FILE");
  command.add_flag("--quiet", telling.quiet, "Print nothing but errors");
  command.add_flag("--json", telling.json, "Print the result as JSON");
  command.add_flag("--watch", telling.watch, "Make the outputs anew when a file that was read changes");
}

}  // namespace pomona
