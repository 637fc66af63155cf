// A run that makes items in a folder, as the command line asks for it: what `pomona batch` and `pomona data` share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/batch/item_work.h"
#include "cli/batch/workplace.h"
#include "generator/base/error.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

struct RunWords {
  std::string output, shard, memory;
  bool resume = false, update = false, verify = false, quiet = false, json = false;
  int threads = 0;
};

/// Declares -o, --resume, --update, --verify, --shard, --memory, --threads, --quiet and --json.
void add_run_options(CLI::App& command, RunWords& words);

/// Checks the words that need no file. \throws Error (usage)
void check_run_words(const RunWords& words);

/// The folder's record, what is told before the work begins, and the one share that is made in place of --shard.
struct RunOfItems {
  std::string record;
  std::vector<std::string> warnings = {};
  std::optional<Shard> only = {};
};

/// Makes what is missing in the folder, or says why it is not touched.
/// \throws Error as run_batch(), and (cannot_create) for a folder that holds something else.
ExitStatus made_in_folder(ItemWork& work, const RunOfItems& run, const RunWords& words);

}  // namespace pomona
