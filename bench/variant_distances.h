// How different variants are from each other.
#pragma once

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona::bench {

/// Root mean square distance of equal vertices, metres; `min` over all pairs of variants.
struct VariantDistances {
  double min = 0, mean = 0;
  int first = 0, second = 0;  ///< the two nearest, as indices
};

/// From some vertices of each variant. The nearest pairs are then measured over all vertices, which `all_of` gives.
VariantDistances distances_between(const std::vector<std::vector<glm::vec3>>& variants,
                                   const std::function<std::vector<glm::vec3>(int)>& all_of);

}  // namespace pomona::bench
