// From items to manifest.json and index.html, which list them all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/batch/run_batch.h"
#include "cli/batch/workplace.h"

namespace pomona {

struct AssembleReport {
  std::int64_t items = 0;
  std::int64_t missing = 0;
  std::vector<std::string> first_missing;  ///< at most twenty
  std::vector<FailedItem> failed;
};

/// Reads the folder's batch.json and all items; writes manifest.json and index.html if none is missing. Memory grows
/// only with the number of failed items.
/// \throws Error (bad_data) if the folder holds no batch, (cannot_create, io_error)
AssembleReport assemble(Workplace& workplace);

/// The bytes of a batch's batch.json; empty if there is none. \throws Error (io_error)
std::string batch_record_in(const std::filesystem::path& folder);

}  // namespace pomona
