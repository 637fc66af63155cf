// item.json: the facts of one item. It lies in the item's folder; a batch's manifest has all of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generator/batch/batch_plan.h"
#include "generator/piece/solid.h"

namespace pomona {

struct RecordedFile {
  std::string name;
  std::uint64_t bytes = 0;
  std::string sha256;
};

/// The result of an item: its pieces and files, or why there are none.
struct ItemOutcome {
  std::span<const Solid> pieces = {};
  std::vector<RecordedFile> files = {};
  std::vector<std::string> warnings = {};
  std::string error = {};
};

/// SHA-256 of everything that an item is made of: the program's version, the template and other files, and all that is
/// asked for, but not its place. Two items with the same recipe have the same files.
std::string item_recipe(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item);

/// The record of an item that lies elsewhere, for its new place: an entry with so many items, and its number in it.
/// \throws Error (bad_data) if it is no record.
std::string moved_record(const std::string& record, const std::string& entry, std::int64_t items, std::int64_t number);

/// One line of JSON, with a line break.
std::string item_record(const BatchPlan& plan, const BatchVariant& variant, const BatchItem& item,
                        const ItemOutcome& outcome);

/// The part of it that is read again.
struct RecordedItem {
  std::string item;    ///< its folder: "halves/042"
  std::string recipe;  ///< item_recipe() of what it was made of; empty in those of older versions
  std::string template_name;
  std::uint64_t seed = 0;
  std::string knives;  ///< separated by spaces
  std::size_t pieces = 0;
  double volume = 0;  ///< volume of all pieces, cubic metres
  std::vector<RecordedFile> files;
  std::string error;
};

/// \throws Error (bad_data) with line and column if it is no record.
RecordedItem parse_item_record(const std::string& json, const std::string& file);

}  // namespace pomona
