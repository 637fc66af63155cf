// The data set that is asked for on the command line.
#pragma once

#include <filesystem>
#include <string>

#include "generator/data/data_plan.h"

namespace pomona {

/// A data set file with its templates, which are found as `pomona cut` finds them, and whose styles are there.
/// \param behind pictures in place of the file's, paths from the current folder.
/// \throws Error as read_data(), with_backgrounds(), planned() and find_style() do.
DataPlan wanted_data(const std::filesystem::path& file, const BackgroundPaths& behind = {});

/// Its batch.json, as this program writes it.
std::string record_of(const DataPlan& plan);

}  // namespace pomona
