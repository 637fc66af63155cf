// Sets the instances of a template's places into a grown fruit.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "generator/base/random.h"
#include "generator/compose/grown_fruit.h"
#include "generator/template/template.h"

namespace pomona {

/// Grows one individual of a drawn template for each key, before blur is split.
using GrowPlaced = std::function<std::vector<GrownFruit>(const Template& placed, std::span<const VariantKey> keys,
                                                         const GrowOptions& options)>;

/// The fruit with all that its template places, before blur is split. Instance i of place P has the key of bits 2i and
/// 2i + 1 of the stream "place/P", so one place more disturbs no other; at seed 0 all are as drawn.
/// \param key of the fruit's species
/// \throws Error (bad_data) naming template and place for more than 4096 instances or 4 million triangles, before
/// anything is grown, and where what is placed cannot be pressed
GrownFruit with_placed(GrownFruit fruit, const Template& variant, VariantKey key, const GrowOptions& options,
                       const GrowPlaced& grow_placed);

}  // namespace pomona
