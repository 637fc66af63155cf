// batch.json: the batch of a folder. Two batches with the same record make the same bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "generator/batch/batch_plan.h"

namespace pomona {

/// Everything that the items' bytes depend on, as JSON.
/// \param program "pomona 0.2.0".
std::string batch_record(const BatchPlan& plan, const std::string& program);

/// The part that is read again, so that a folder can be merged without its batch file.
struct RecordedEntry {
  std::string name;
  std::int64_t items = 0;
  std::int64_t items_of_a_variant = 1;  ///< items of one individual; shards divide individuals
};
struct RecordedBatch {
  std::string program, name, title;
  std::uint64_t seed = 0;
  std::vector<RecordedEntry> entries;
  std::int64_t items() const;
};

/// \throws Error (bad_data) with line and column if it is no record.
RecordedBatch parse_batch_record(const std::string& json, const std::string& file);

}  // namespace pomona
