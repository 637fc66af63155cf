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

/// The scene of one seed, with names that differ from those of the others.
std::vector<Solid> named_by_seed(std::vector<Solid> solids, std::uint64_t seed);

/// All of them side by side on the table.
Scene row_of(std::vector<Solid> solids, const Style& style);

}  // namespace pomona
