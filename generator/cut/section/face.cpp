#include "generator/cut/section/face.h"

#include <algorithm>
#include <tuple>

#include <glm/geometric.hpp>

namespace pomona {

std::span<const EdgeUse> Face::uses(std::uint32_t p, std::uint32_t q) const {
  const auto less = [](const EdgeUse& a, const EdgeUse& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; };
  const EdgeUse key{std::min(p, q), std::max(p, q), 0, false};
  const auto range = std::equal_range(edges.begin(), edges.end(), key, less);
  return {range.first, range.second};
}

void Face::sort_edges() {
  std::sort(edges.begin(), edges.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
  });
}

double distance(const Face& face, std::uint32_t p, std::uint32_t q) {
  return glm::distance(face.place[p], face.place[q]);
}

}  // namespace pomona
