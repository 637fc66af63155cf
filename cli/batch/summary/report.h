// The summary of a run.
#pragma once

#include <string>

#include "cli/batch/run_batch.h"

namespace pomona {

/// "made 24 items in 3 s (8.1 a second), 2 were there, 1 failed: out"
std::string summary(const RunReport& report, const std::string& folder);

/// The same as JSON.
std::string report_as_json(const RunReport& report);

}  // namespace pomona
