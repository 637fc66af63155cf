// A spiral about the axis, from pole to pole of a fruit.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// Tells how far along the fruit's outline, bottom to top, a point lies. The outline is the convex hull of the skin,
/// turned into one half-plane about the axis. A point within or without it is where the ray from the nearest point of
/// the fruit's middle, a stretch of the axis, through it meets the outline.
class OutlinePlace {
 public:
  explicit OutlinePlace(const TriangleTree& skin);

  double along(const glm::dvec3& point) const;  ///< metres from the bottom, along the outline
  double length() const { return along_.back(); }

 private:
  std::vector<glm::dvec2> outline_;  ///< distance from the axis, height; from the bottom to the top
  std::vector<double> along_;
  double low_middle_ = 0, high_middle_ = 0;  ///< heights of the ends of the fruit's middle
};

/// How far a point, `along` metres from the bottom of the outline, is from the middle of the nearest ridge, in turns
/// about the axis, in [-0.5, 0.5]. The ridge rises by `pitch` metres along the outline with each turn.
double turns_from_ridge(double along, const glm::dvec3& point, double pitch);

}  // namespace pomona
