// What a run says when it is done.
#pragma once

#include <string>

#include "cli/batch/run_batch.h"

namespace pomona {

/// "made 24 items in 3 s (8.1 a second), 2 were there, 1 failed: out"
std::string summary(const RunReport& report, const std::string& folder);

/// The same for programs.
std::string report_as_json(const RunReport& report);

/// In what the batch that a folder holds differs from the one wanted, both as batch.json: `another batch, "small"`.
std::string difference(const std::string& there, const std::string& wanted);

}  // namespace pomona
