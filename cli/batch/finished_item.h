// An item as it lies on disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "generator/batch/item_record.h"

namespace pomona {

struct FinishedItem {
  std::string record;  ///< item.json, with its line break
  RecordedItem facts;
};

enum class FileCheck { lengths, hashes };

/// Nothing if the item is missing or incomplete: its record must name it, and every file must have the size in the
/// record, and with FileCheck::hashes its SHA-256.
std::optional<FinishedItem> finished_item(const std::filesystem::path& folder, const std::string& item,
                                          FileCheck check = FileCheck::lengths);

/// The same of an item that lies in this very folder, whatever place it names.
std::optional<FinishedItem> finished_item_at(const std::filesystem::path& folder, FileCheck check);

}  // namespace pomona
