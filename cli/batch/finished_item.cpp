#include "cli/batch/finished_item.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "generator/base/error.h"

namespace fs = std::filesystem;

namespace pomona {

std::optional<FinishedItem> finished_item(const fs::path& folder, const std::string& item) {
  const fs::path file = folder / item / "item.json";
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  FinishedItem found{{std::istreambuf_iterator<char>(stream), {}}, {}};
  try {
    found.facts = parse_item_record(found.record, file.string());
  } catch (const Error&) {
    return {};
  }
  const bool is_one_line =
      found.record.ends_with('\n') && std::count(found.record.begin(), found.record.end(), '\n') == 1;
  if (found.facts.item != item || !is_one_line) return {};

  for (const RecordedFile& listed : found.facts.files) {
    std::error_code failed;
    if (fs::file_size(folder / item / listed.name, failed) != listed.bytes || failed) return {};
  }
  return found;
}

}  // namespace pomona
