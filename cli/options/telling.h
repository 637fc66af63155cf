// Options of a command's output on the terminal, and of --stats and --watch.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

struct Telling {
  std::string stats;   ///< file for times and counts; empty = none
  bool quiet = false;  ///< print only errors
  bool json = false;   ///< the result as JSON on standard output
  bool watch = false;  ///< make the outputs again when an input file changes
};

/// Declares --stats, --quiet, --json and --watch. `telling` must outlive the parsing.
void add_telling_options(CLI::App& command, Telling& telling);

}  // namespace pomona
