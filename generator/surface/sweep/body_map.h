// The map from the straight fruit with the proportions of the drawing to the final shape, for every swept point.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/template/template.h"

namespace pomona {

/// The unit vector from the straight fruit's axis to a place; +X for places on it.
glm::dvec3 away_from_axis(const glm::dvec3& straight);

/// Applies the fruit's proportions, then its twist, then its bend. Cross-sections stay plane and perpendicular to the
/// bent axis; the axis keeps its length, as in [Barr 1984], but its curvature may change along the axis. The map is
/// smooth and one-to-one as long as the strain of the bend is small enough (bend_strain.h).
class BodyMap {
 public:
  explicit BodyMap(const Template& fruit);

  /// True if every point stays where it is, to the bit.
  bool is_identity() const { return !changes_proportions_ && !bends_ && !twists_; }

  glm::dvec3 operator()(const glm::dvec3& drawn) const;

 private:
  glm::dvec3 placed(const glm::dvec3& straight, double place) const;
  glm::dvec3 twisted(const glm::dvec3& straight, double place) const;
  glm::dvec3 bent(const glm::dvec3& straight, double place) const;
  glm::dvec2 axis_at(double place) const;

  Proportions proportions_;
  AxisBend bend_;
  bool changes_proportions_ = false, bends_ = false, twists_ = false;
  double low_ = 0;                   ///< height of the bottom, metres
  double half_ = 0;                  ///< half of the drawing's height, metres
  double half_length_ = 0;           ///< half of the axis's length, metres
  glm::dvec2 towards_{1, 0};         ///< x and z of the direction in which the axis bends
  std::vector<glm::dvec2> axis_;     ///< the bent axis at equally many places: towards the direction, and up
  std::vector<glm::dvec2> tangent_;  ///< tangent of the axis there, unit
};

}  // namespace pomona
