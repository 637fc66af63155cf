// Builds a bounding volume hierarchy (BVH): the division and numbering of nodes, for any kind of volume and split.
#pragma once

#include <cstdint>
#include <vector>

namespace pomona {

/// Divides a list of `count` items. A node has at least the members
///
///     std::uint32_t first;  // leaf: index of its first item; else of its left child; the right child follows
///     std::uint32_t count;  // leaf: number of items; else 0
///
/// and children come after their parents, so that volumes are filled in from the last node to the first.
/// \param max_in_leaf nodes with more items are divided
/// \param split called as split(first, count): may reorder these items; returns how many of them go to the left child,
/// at
///        least 1 and less than `count`
template <typename Node, typename Split>
std::vector<Node> bounding_volume_hierarchy(std::uint32_t count, std::uint32_t max_in_leaf, const Split& split) {
  std::vector<Node> nodes(1);
  const auto divide = [&](const auto& self, std::uint32_t node, std::uint32_t first, std::uint32_t of_node) -> void {
    nodes[node].first = first;
    nodes[node].count = of_node;
    if (of_node <= max_in_leaf) return;
    const std::uint32_t of_left = split(first, of_node);
    const auto left = static_cast<std::uint32_t>(nodes.size());
    nodes.resize(nodes.size() + 2);
    nodes[node].first = left;
    nodes[node].count = 0;
    self(self, left, first, of_left);
    self(self, left + 1, first + of_left, of_node - of_left);
  };
  divide(divide, 0, 0, count);
  return nodes;
}

}  // namespace pomona
