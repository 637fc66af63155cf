// index.html: a page that shows all items of a batch, from disk and without a network.
#pragma once

#include <span>
#include <string>

#include "generator/base/embedded_file.h"
#include "generator/batch/batch_record.h"
#include "generator/batch/item_record.h"

namespace pomona {

/// Writes contact_sheet.html with the items between its two halves.
class ContactSheet {
 public:
  explicit ContactSheet(const RecordedBatch& batch);

  const std::string& before_items() const { return before_; }
  const std::string& after_items() const { return after_; }

  /// One item as a JSON array for a script element: folder, template, seed, knives, pieces, volume (millilitres), names
  /// of files, and the reason if it failed.
  static std::string row(const RecordedItem& item);

 private:
  std::string before_, after_;
};

/// contact_sheet.html, embedded when the program was built.
std::span<const EmbeddedFile> contact_sheet_files();

}  // namespace pomona
