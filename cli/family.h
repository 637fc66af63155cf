// Several variants of one fruit at once: --seeds of grow and cut.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/deliver.h"
#include "cli/outputs.h"
#include "cli/shared_options.h"
#include "generator/piece/solid.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own
class App;
}

namespace pomona {

/// Declares --seeds on a command.
void add_seeds_option(CLI::App& command, std::string& seeds);

/// "1-5" or "0,2,7": 1 to 64 of them. \throws Error (usage) for anything else.
std::vector<std::uint64_t> parse_seeds(const std::string& text);

/// \throws Error (usage) for outputs that show one fruit alone, and for options that do not go with several.
void check_family(const SharedOptions& options, const std::vector<Output>& outputs);

/// The options once for each seed. \throws Error as parse_seeds()
std::vector<SharedOptions> each_seed(const std::string& seeds, const SharedOptions& options);

/// What was made of one seed, named so that it is told from what was made of the others.
std::vector<Solid> named_by_seed(std::vector<Solid> solids, std::uint64_t seed);

/// The outputs that are not live, of all of them side by side on the table.
void add_row(std::vector<Solid> solids, const std::vector<Output>& outputs, Delivery& delivery);

}  // namespace pomona
