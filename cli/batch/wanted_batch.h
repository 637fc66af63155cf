// The batch that the command line names, and its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/batch/entry_styles.h"
#include "generator/batch/batch_plan.h"

namespace pomona {

/// A batch file with its templates, which are searched as by `pomona cut`.
/// \throws Error as read_batch() and planned() do.
BatchPlan wanted_batch(const std::filesystem::path& file);

/// The bytes of its batch.json.
std::string record_of(const BatchPlan& plan);

/// \param there the folder's batch.json, or empty. \param wanted that of the batch to be made.
/// \throws Error (cannot_create), with the difference, if the folder holds another batch.
void check_holds_no_other(const std::filesystem::path& folder, const std::string& there, const std::string& wanted);

/// As check_holds_no_other(), but refuses only a batch of another name, and what is no batch.
void check_holds_no_other_name(const std::filesystem::path& folder, const std::string& there,
                               const std::string& wanted);

/// The styles of each entry. \throws Error as find_style()
std::vector<EntryStyles> styles_of(const BatchPlan& plan);

/// Warnings for options that have no effect on any entry.
std::vector<std::string> batch_warnings(const BatchPlan& plan);

}  // namespace pomona
