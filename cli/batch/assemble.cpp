#include "cli/batch/assemble.h"

#include <fstream>
#include <functional>

#include <nlohmann/json.hpp>

#include "cli/batch/finished_item.h"
#include "cli/batch/summary/contact_sheet.h"
#include "cli/data/data_files.h"
#include "generator/base/error.h"
#include "generator/base/first_bytes.h"
#include "generator/base/json_text.h"
#include "generator/batch/batch_record.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::size_t max_named = 20;
constexpr std::size_t longest_record = std::size_t{64} << 20;  // bytes

/// Calls `visit` with each item's folder, in the order of the batch.
void for_items(const RecordedBatch& batch, const std::function<void(const std::string&)>& visit) {
  for (const RecordedEntry& entry : batch.entries)
    for (std::int64_t n = 0; n < entry.items; ++n) visit(item_path(entry.name, entry.items, n));
}

AssembleReport surveyed(const fs::path& folder, const RecordedBatch& batch) {
  AssembleReport report;
  report.items = batch.items();
  for_items(batch, [&](const std::string& item) {
    const auto found = finished_item(folder, item);
    if (found && !found->facts.error.empty()) report.failed.push_back({item, found->facts.error});
    if (found) return;
    ++report.missing;
    if (report.first_missing.size() < max_named) report.first_missing.push_back(item);
  });
  return report;
}

/// The item in a folder that this run holds alone, so that nothing changes between two visits.
FinishedItem item_at(const fs::path& folder, const std::string& item) {
  if (auto found = finished_item(folder, item)) return std::move(*found);
  throw Error(ExitStatus::io_error, {{{(folder / item).string(), 0, 0, {}}, "has gone", {}}});
}

/// Writes one line for each item, so that line-based tools can read the manifest.
void write_manifest(const Workplace::Writer& write, const fs::path& folder, const std::string& record,
                    const RecordedBatch& batch, const AssembleReport& report) {
  write("{\"format\":1,\n\"batch\":" + json_text(nlohmann::ordered_json::parse(record)) +
        ",\n\"failed\":" + std::to_string(report.failed.size()) + ",\n\"items\":[");
  const char* separator = "\n";
  for_items(batch, [&](const std::string& item) {
    std::string line = item_at(folder, item).record;
    line.pop_back();
    write(separator + line);
    separator = ",\n";
  });
  write("\n]}\n");
}

void write_page(const Workplace::Writer& write, const fs::path& folder, const RecordedBatch& batch) {
  const ContactSheet sheet(batch);
  write(sheet.before_items());
  bool is_first = true;
  for_items(batch, [&](const std::string& item) {
    write((is_first ? "\n" : ",\n") + ContactSheet::row(item_at(folder, item).facts));
    is_first = false;
  });
  write(sheet.after_items());
}

}  // namespace

std::string batch_record_in(const fs::path& folder) {
  std::ifstream stream(folder / "batch.json", std::ios::binary);
  if (!stream) return {};
  std::string text = first_bytes(stream, longest_record);
  if (stream.bad())
    throw Error(ExitStatus::io_error, {{{(folder / "batch.json").string(), 0, 0, {}}, "cannot be read", {}}});
  return text;
}

AssembleReport assemble(Workplace& workplace) {
  const fs::path& folder = workplace.folder();
  const std::string record = batch_record_in(folder);
  const RecordedBatch batch = parse_batch_record(record, (folder / "batch.json").string());
  AssembleReport report = surveyed(folder, batch);
  if (report.missing > 0) return report;
  workplace.put_file("manifest.json",
                     [&](const Workplace::Writer& write) { write_manifest(write, folder, record, batch, report); });
  workplace.put_file("index.html", [&](const Workplace::Writer& write) { write_page(write, folder, batch); });
  if (is_data_record(record)) write_data_files(workplace, record);
  workplace.remove_aside();
  return report;
}

}  // namespace pomona
