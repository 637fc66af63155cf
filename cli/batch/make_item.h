// One item, from its numbers to the bytes of its files. Nothing else affects the bytes, and nothing is written here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/batch/entry_styles.h"
#include "cli/batch/item_work.h"
#include "generator/batch/batch_plan.h"
#include "generator/order/ordered_fruit.h"

namespace pomona {

/// One individual, for all items that are made of it.
OrderedFruit grown_variant(const BatchPlan& plan, const Variation& variation, const BatchVariant& which);

/// \param grown null if growing failed; then `growing_error` is the reason.
/// \throws errors for a lack of memory or threads (exhausted.h), because a later run may have enough.
MadeItem make_item(const BatchPlan& plan, const BatchVariant& which, const OrderedFruit* grown,
                   const std::string& growing_error, const BatchItem& item, const EntryStyles& styles);

/// An estimate of the memory that an item takes while it is made, bytes. docs/guides/batch.md says what it rests on.
std::uint64_t memory_of_an_item(const PlannedEntry& entry);

}  // namespace pomona
