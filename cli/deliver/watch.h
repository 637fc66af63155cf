// --watch: makes a command's outputs again when an input file changes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/options/telling.h"
#include "generator/base/error.h"

namespace pomona {

/// Makes the outputs, and with --watch makes them again whenever one of the files that `words` read has changed and is
/// stable again, until a signal ends the program. It prints errors and goes on. \param written names of the outputs,
/// without the statistics. \throws Error (usage) as check_not_read(), and with --watch if an output is standard output,
/// which cannot be made again; without --watch what `make` throws.
ExitStatus made_or_watched(const Telling& telling, std::vector<std::string> written,
                           const std::vector<std::string>& words, const std::function<ExitStatus()>& make);

}  // namespace pomona
