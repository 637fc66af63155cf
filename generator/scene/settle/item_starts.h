// Where those pieces of a heap begin that are not dropped from places drawn.
#pragma once

#include <optional>
#include <vector>

#include "generator/scene/settle/arrange.h"
#include "generator/scene/settle/heap_plan.h"

namespace pomona {

/// \throws Error (bad_data) at the place of the first item that would fall, if the dish has no hollow.
void refuse_shallow_dish(const HeapPlan& plan);

/// One of each item; none where it is dropped, or finds no room. \throws Error (bad_data) where pieces are to be
/// strewn on what has nothing that looks upwards.
std::vector<std::optional<Start>> item_starts(const HeapPlan& plan);

}  // namespace pomona
