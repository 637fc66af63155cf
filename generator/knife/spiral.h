// A spiral about the axis, from pole to pole of a fruit.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// The position of a point along the fruit's outline, from bottom to top. The outline is the convex hull of the skin
/// after all points are turned about the axis into one half-plane. A point that is not on it is projected: by the ray
/// from the nearest point of the fruit's middle, a segment of the axis.
class OutlinePlace {
 public:
  explicit OutlinePlace(const TriangleTree& skin);

  double along(const glm::dvec3& point) const;  ///< distance from the bottom along the outline, metres
  double length() const { return along_.back(); }

 private:
  std::vector<glm::dvec2> outline_;  ///< distance from the axis, height; from the bottom to the top
  std::vector<double> along_;
  double low_middle_ = 0, high_middle_ = 0;  ///< heights of the ends of the fruit's middle
};

/// The distance of a point from the middle of the nearest ridge, in turns about the axis, in [-0.5, 0.5].
/// \param along position of the point along the outline, metres from the bottom.
/// \param pitch the ridge rises by this along the outline with each turn, metres.
double turns_from_ridge(double along, const glm::dvec3& point, double pitch);

}  // namespace pomona
