// Several variants of one fruit at once: --seeds of grow and cut.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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

/// What `of_one` makes of each seed's options, one after another; names tell the seed.
std::vector<Solid> family(const std::vector<std::uint64_t>& seeds, const SharedOptions& options,
                          const std::function<std::vector<Solid>(const SharedOptions&)>& of_one);

}  // namespace pomona
