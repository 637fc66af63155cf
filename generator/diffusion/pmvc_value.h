// A positive mean value.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace pomona {

/// The positive mean value at a point.
struct PmvcValue {
  glm::dvec3 color{0};    ///< linear
  std::int32_t part = 0;  ///< the one with the largest share of the weight, an index into part_names
  double weight = 0;      ///< integral of 1 / d over the directions, 1 / metres; 0 where nothing is seen
  double fourth = 0;      ///< the fourth value that vertices may have beside their colours; 0 if there is none
};

}  // namespace pomona
