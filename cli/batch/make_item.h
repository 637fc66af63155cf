// One item, from its numbers to the bytes of its files. Nothing else affects the bytes, and nothing is written here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/batch/entry_styles.h"
#include "generator/batch/batch_plan.h"
#include "generator/order/ordered_fruit.h"
#include "render/export/named_file.h"

namespace pomona {

struct MadeItem {
  std::string item;              ///< its folder: "halves/042"
  std::vector<NamedFile> files;  ///< item.json is the last
  std::string error;             ///< the reason if it failed; then item.json is the only file
};

/// The fruit that several items share.
OrderedFruit grown_variant(const BatchPlan& plan, const Variation& variation, const BatchVariant& which);

/// \param grown null if growing failed; then `growing_error` is the reason.
/// \throws errors for a lack of memory or threads (exhausted.h), because a later run may have enough.
MadeItem make_item(const BatchPlan& plan, const BatchVariant& which, const OrderedFruit* grown,
                   const std::string& growing_error, const BatchItem& item, const EntryStyles& styles);

/// The reason as a text that is the same in every run.
std::string reason_of(const std::exception& error);

/// An estimate of the memory for making an item, bytes; docs/guides/batch.md explains it.
std::uint64_t memory_of_an_item(const PlannedEntry& entry);

}  // namespace pomona
