// Which boxes of many meet each other.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/mesh/box.h"

namespace pomona {

/// Every two different boxes that meet, once, the smaller index first; in an order that the boxes alone decide.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_boxes(const std::vector<Box<float>>& boxes);

}  // namespace pomona
