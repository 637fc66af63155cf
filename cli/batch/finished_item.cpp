#include "cli/batch/finished_item.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/sha256.h"

namespace fs = std::filesystem;

namespace pomona {

std::optional<FinishedItem> finished_item_at(const fs::path& folder, FileCheck check) {
  const fs::path file = folder / "item.json";
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
  if (!is_one_line) return {};

  for (const RecordedFile& listed : found.facts.files) {
    const fs::path place = folder / listed.name;
    std::error_code failed;
    if (fs::file_size(place, failed) != listed.bytes || failed) return {};
    if (check == FileCheck::hashes && sha256(file_bytes(place, listed.bytes)) != listed.sha256) return {};
  }
  return found;
}

std::optional<FinishedItem> finished_item(const fs::path& folder, const std::string& item, FileCheck check) {
  std::optional<FinishedItem> found = finished_item_at(folder / item, check);
  return found && found->facts.item == item ? found : std::nullopt;
}

}  // namespace pomona
