// A spiral about the axis, from pole to pole of a fruit.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// Tells how far along the fruit's outline, bottom to top, a point lies. The outline is the smallest convex one around
/// the skin, turned about the axis; points within and without are seen from the nearest part of the fruit's middle.
class OutlinePlace {
 public:
  explicit OutlinePlace(const TriangleTree& skin);

  double along(const glm::dvec3& point) const;  ///< metres from the bottom, along the outline
  double length() const { return along_.back(); }

 private:
  std::vector<glm::dvec2> outline_;  ///< distance from the axis, height; from the bottom to the top
  std::vector<double> along_;
  double low_middle_ = 0, high_middle_ = 0;
};

/// Turns from the middle of the ridge next to this point, in [-0.5, 0.5]: the ridge rises by `pitch` along the outline
/// with each turn about the axis.
double turns_from_ridge(double along, const glm::dvec3& point, double pitch);

}  // namespace pomona
