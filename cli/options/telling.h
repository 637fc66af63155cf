// What a command tells while it works and when it is done, as it was asked.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

struct Telling {
  std::string stats;   ///< file for times and counts; empty = none
  bool quiet = false;  ///< nothing but errors
  bool json = false;   ///< the result as JSON on standard output
  bool watch = false;  ///< the outputs are made anew when a file that was read changes
};

/// Declares --stats, --quiet, --json and --watch. `telling` must outlive the parsing.
void add_telling_options(CLI::App& command, Telling& telling);

}  // namespace pomona
