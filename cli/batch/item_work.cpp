#include "cli/batch/item_work.h"

#include "generator/base/error.h"

namespace pomona {

std::string path_of(const RecordedEntry& entry, std::int64_t number) {
  return item_path(entry.name, entry.items, number);
}

std::string reason_of(const std::exception& error) {
  if (const auto* told = dynamic_cast<const Error*>(&error)) return told->diagnostics().front().message;
  return std::string("this is a bug in pomona: ") + error.what();
}

}  // namespace pomona
