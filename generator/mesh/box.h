// Boxes along the axes, in single or double precision.
#pragma once

#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// The smallest box around everything that was added to it. An empty box has its low corner above its high corner; both
/// are finite, because graphics processors turn infinities into NaN.
template <typename T>
struct Box {
  using Point = glm::vec<3, T>;
  Point low{std::numeric_limits<T>::max()};
  Point high{std::numeric_limits<T>::lowest()};

  void add(const Point& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }

  Point size() const { return high - low; }
  Point center() const { return T(0.5) * (low + high); }

  Box moved(const Point& by) const { return {low + by, high + by}; }

  /// True if they have a point in common.
  bool meets(const Box& b) const {
    // Without branches, because the processor could not predict them.
    return (low.x <= b.high.x) & (b.low.x <= high.x) & (low.y <= b.high.y) & (b.low.y <= high.y) & (low.z <= b.high.z) &
           (b.low.z <= high.z);
  }
};

/// The axis, 0 to 2, with the largest size; the first one of equal axes.
template <typename T>
int longest_axis(const glm::vec<3, T>& size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// The smallest box around a triangle.
template <typename T>
Box<T> box_around(const glm::vec<3, T>& a, const glm::vec<3, T>& b, const glm::vec<3, T>& c) {
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

/// The smallest box around some points.
template <typename T>
Box<T> box_around(const std::vector<glm::vec<3, T>>& points) {
  Box<T> box;
  for (const glm::vec<3, T>& point : points) box.add(point);
  return box;
}

/// Squared distance between two boxes, 0 where they meet.
template <typename T>
T squared_distance(const Box<T>& a, const Box<T>& b) {
  const glm::vec<3, T> apart = glm::max(glm::max(a.low - b.high, b.low - a.high), glm::vec<3, T>(0));
  return glm::dot(apart, apart);
}

/// Squared distance from a point to a box, 0 inside.
template <typename T>
T squared_distance(const Box<T>& box, const glm::vec<3, T>& point) {
  const glm::vec<3, T> outside = glm::max(glm::max(box.low - point, point - box.high), glm::vec<3, T>(0));
  return glm::dot(outside, outside);
}

}  // namespace pomona
