// The batch that is asked for on the command line, and the folder it is to be made in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/batch/entry_styles.h"
#include "generator/batch/batch_plan.h"

namespace pomona {

/// A batch file with its templates, which are found as `pomona cut` finds them.
/// \throws Error as read_batch() and planned() do.
BatchPlan wanted_batch(const std::filesystem::path& file);

/// Its batch.json, as this program writes it.
std::string record_of(const BatchPlan& plan);

/// \param there the folder's batch.json, or nothing. \param wanted that of the batch asked for.
/// \throws Error (cannot_create) saying in what they differ, if the folder holds another batch.
void check_holds_no_other(const std::filesystem::path& folder, const std::string& there, const std::string& wanted);

/// As check_holds_no_other(), but refuses only a batch of another name, and what is no batch.
void check_holds_no_other_name(const std::filesystem::path& folder, const std::string& there,
                               const std::string& wanted);

/// The styles of each entry. \throws Error as find_style()
std::vector<EntryStyles> styles_of(const BatchPlan& plan);

/// Options that have no effect on any entry.
std::vector<std::string> batch_warnings(const BatchPlan& plan);

}  // namespace pomona
