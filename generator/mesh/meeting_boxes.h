// Which boxes of many meet each other.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/mesh/box.h"

namespace pomona {

using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

/// Every two different boxes that meet, once, the smaller index first; in an order that the boxes alone decide.
std::vector<BoxPair> meeting_boxes(const std::vector<Box<float>>& boxes);

/// Every box of the one sort that meets one of the other: their indices, in an order that the boxes alone decide.
std::vector<BoxPair> meeting_boxes(const std::vector<Box<double>>& one, const std::vector<Box<double>>& other);

}  // namespace pomona
