// Which boxes of many meet each other.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "generator/mesh/box.h"

namespace pomona {

using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

/// Every two different boxes that meet, once, the smaller index first; in an order that the boxes alone decide.
std::vector<BoxPair> meeting_boxes(const std::vector<Box<float>>& boxes);

/// Calls visit(smaller index, larger index) for the same pairs in the same order, until it returns false.
void visit_meeting_boxes(const std::vector<Box<float>>& boxes,
                         const std::function<bool(std::uint32_t, std::uint32_t)>& visit);

/// Every box of the one sort that meets one of the other: their indices, in an order that the boxes alone decide.
std::vector<BoxPair> meeting_boxes(const std::vector<Box<double>>& one, const std::vector<Box<double>>& other);

}  // namespace pomona
