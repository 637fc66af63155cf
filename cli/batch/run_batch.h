// Making a batch, or a shard of one.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/entry_styles.h"
#include "cli/batch/finished_item.h"
#include "cli/batch/tally.h"
#include "cli/batch/workplace.h"
#include "cli/deliver/progress.h"
#include "generator/base/parallel.h"
#include "generator/batch/batch_plan.h"

namespace pomona {

struct RunOptions {
  Shard shard;
  Threads threads;
  std::uint64_t memory = 0;              ///< bytes for all items that are made at once; 0 = no limit
  FileCheck check = FileCheck::lengths;  ///< of existing items
};

struct FailedItem {
  std::string item, reason;
};

struct RunReport {
  Tally tally;
  std::vector<FailedItem> failed;  ///< in the order of the items
};

/// Makes the missing items. Failed items are counted and leave a record; SIGINT, SIGTERM and SIGHUP end the run after
/// the current items.
/// \throws Error (cannot_create, io_error) if something cannot be written, (locked) after a signal, (out_of_memory) if
/// memory or threads did not suffice for some items, which stay missing. Complete items stay.
RunReport run_batch(const BatchPlan& plan, const std::vector<EntryStyles>& styles, Workplace& workplace,
                    const RunOptions& options, Progress& progress);

/// True if any item of the shard exists.
bool has_any_item(const BatchPlan& plan, const std::filesystem::path& folder, const Shard& shard);

}  // namespace pomona
