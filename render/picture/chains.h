// Chains: many short links joined to the long lines that a pen would draw (as in section 3 of [Northrup & Markosian
// 2000], for links that already share their nodes).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

struct ChainLink {
  std::uint32_t a = 0, b = 0;  ///< nodes
};

/// Links in walking order; `forward[i]` tells whether links[i] is walked from a to b. A closed chain ends where
/// it starts.
struct Chain {
  std::vector<std::uint32_t> links;
  std::vector<std::uint8_t> forward;
  bool closed = false;
};

/// Every link is in exactly one chain. Where two links meet, they are joined unless they turn back; where more meet,
/// the straightest pairs are joined. The order depends only on the order of the links and the positions of the nodes.
std::vector<Chain> chained(std::span<const ChainLink> links, std::span<const glm::dvec2> nodes);

/// The nodes of a chain in walking order; for a closed one the first is not repeated.
std::vector<std::uint32_t> nodes_of(const Chain& chain, std::span<const ChainLink> links);

}  // namespace pomona
