// Finds all pairs of overlapping boxes.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/box.h"

namespace pomona {

using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

/// Every pair of different boxes that overlap, once, the smaller index first. The order depends only on the boxes.
std::vector<BoxPair> overlapping_boxes(const std::vector<Box<float>>& boxes);

/// Calls visit(smaller index, larger index) for the same pairs in the same order, until it returns false.
void visit_overlapping_boxes(const std::vector<Box<float>>& boxes,
                             const std::function<bool(std::uint32_t, std::uint32_t)>& visit);

/// Every pair of a box of `one` and a box of `other` that overlap, as indices. The order depends only on the boxes.
std::vector<BoxPair> overlapping_boxes(const std::vector<Box<double>>& one, const std::vector<Box<double>>& other,
                                       Threads threads = {1});

}  // namespace pomona
