// Several seeds of one fruit side by side: --seeds of grow and cut.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/order/order.h"
#include "generator/scene/scene.h"
#include "render/style/style.h"

namespace pomona {

/// The order once for each of its seeds.
std::vector<Order> each_seed(const Order& order);

/// What was made of one seed, named so that it is told from what was made of the others.
std::vector<Solid> named_by_seed(std::vector<Solid> solids, std::uint64_t seed);

/// All of them side by side on the table.
Scene row_of(std::vector<Solid> solids, const Style& style);

}  // namespace pomona
