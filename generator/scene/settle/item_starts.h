// Start poses of the items that an arrangement places; all others are dropped at random.
#pragma once

#include <optional>
#include <vector>

#include "generator/scene/settle/arrange.h"
#include "generator/scene/settle/heap_plan.h"

namespace pomona {

/// \throws Error (bad_data) if the dish has no hollow and an item would fall into it. Its place is that of the first
/// such item.
void refuse_shallow_dish(const HeapPlan& plan);

/// One start pose per item; nothing where the item is dropped, or finds no room. \throws Error (bad_data) if pieces are
/// to be scattered on a dish with no triangle that faces upwards.
std::vector<std::optional<StartPose>> item_starts(const HeapPlan& plan);

}  // namespace pomona
