// Which boxes of many meet each other.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

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

/// Every two different boxes that meet, once, the smaller index first; in an order that the boxes alone decide.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_boxes(const std::vector<FloatBox>& boxes);

}  // namespace pomona
