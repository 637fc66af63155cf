// --watch: a command's outputs are made anew when a file that it read changes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/options/telling.h"
#include "generator/base/error.h"

namespace pomona {

/// Makes, and with --watch makes again whenever one of the files behind `words` has changed and has come to rest, until
/// a signal ends the program. What goes wrong is printed then, and watching goes on. \param written names of files that
/// are written, the statistics aside. \throws Error (usage) as check_not_read(), and with --watch if one of the files
/// is standard output, which cannot be made anew; without it what `make` throws.
ExitStatus made_or_watched(const Telling& telling, std::vector<std::string> written,
                           const std::vector<std::string>& words, const std::function<ExitStatus()>& make);

}  // namespace pomona
