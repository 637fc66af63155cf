// How a bounding volume hierarchy (BVH) is divided and numbered, whatever its volumes hold and wherever they are split.
#pragma once

#include <cstdint>
#include <vector>

namespace pomona {

/// Divides `count` things that stand in a row. A node has at least the members
///
///     std::uint32_t first;  // leaf: the first of its things; else its left child, which the right one follows
///     std::uint32_t count;  // leaf: how many things; else 0
///
/// and children come after their parents, so that volumes are filled in from the last node to the first.
/// \param most_in_leaf more things than this are divided
/// \param split called as split(first, count): may put these things into another order, and tells how many of them, at
///        least 1 and less than all, are the left child's
template <typename Node, typename Split>
std::vector<Node> bounding_volume_hierarchy(std::uint32_t count, std::uint32_t most_in_leaf, const Split& split) {
  std::vector<Node> nodes(1);
  const auto divide = [&](const auto& self, std::uint32_t node, std::uint32_t first, std::uint32_t of_node) -> void {
    nodes[node].first = first;
    nodes[node].count = of_node;
    if (of_node <= most_in_leaf) return;
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
