// What a run makes: the items of a batch, or the pictures of a data set.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "generator/batch/batch_record.h"
#include "render/export/named_file.h"

namespace pomona {

struct MadeItem {
  std::string item;              ///< its folder: "halves/042"
  std::vector<NamedFile> files;  ///< item.json is the last
  std::string error;             ///< why it could not be made; then item.json is all there is
};

/// Items by entry and number. Those of one variant follow each other, and are made by one thread.
class ItemWork {
 public:
  virtual ~ItemWork() = default;
  virtual std::vector<RecordedEntry> entries() const = 0;

  /// The hash of all that the item is made of; items that differ in nothing but their place have the same.
  virtual std::string recipe(std::size_t entry, std::int64_t number) const = 0;

  /// An estimate of the memory that an item takes while it is made, bytes.
  virtual std::uint64_t memory_of_an_item(std::size_t entry) const = 0;

  /// Makes these items of one variant, in this order, and hands over each when it is made. By any thread.
  /// \throws what says that memory or threads ran out (exhausted.h); all else becomes the item's error.
  using Put = std::function<void(const MadeItem& made)>;
  virtual void make(std::size_t entry, std::span<const std::int64_t> numbers, const Put& put) = 0;
};

/// The folder of an item: "halves/042".
std::string path_of(const RecordedEntry& entry, std::int64_t number);

/// What went wrong, in words that are the same each time.
std::string reason_of(const std::exception& error);

}  // namespace pomona
