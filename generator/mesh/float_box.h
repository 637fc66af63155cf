// Boxes along the axes, in single precision.
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// The least box around some points; empty (low above high) until one is put in.
struct FloatBox {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const FloatBox& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  bool meets(const FloatBox& b) const {
    // Without branches: they could not be foreseen.
    return (low.x <= b.high.x) & (b.low.x <= high.x) & (low.y <= b.high.y) & (b.low.y <= high.y) & (low.z <= b.high.z) &
           (b.low.z <= high.z);
  }
};

}  // namespace pomona
