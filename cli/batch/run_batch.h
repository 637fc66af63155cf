// Making a batch, or a shard of one.
#pragma once

#include <string>
#include <vector>

#include "cli/batch/finished_item.h"
#include "cli/batch/item_work.h"
#include "cli/batch/summary/tally.h"
#include "cli/batch/workplace.h"
#include "cli/deliver/progress.h"
#include "generator/base/parallel.h"

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

/// Makes what is not there yet. Items that fail are noted, and leave a record; SIGINT, SIGTERM and SIGHUP end the run
/// after the items under way.
/// \throws Error (cannot_create, io_error) if something cannot be written, (locked) if it was ended by a signal,
/// (out_of_memory) if memory or threads did not suffice for items, which then are missing. What
/// is whole by then stays.
RunReport run_batch(ItemWork& work, Workplace& workplace, const RunOptions& options, Progress& progress);

/// Whether any item of the shard is there.
bool has_any_item(const ItemWork& work, const std::filesystem::path& folder, const Shard& shard);

}  // namespace pomona
