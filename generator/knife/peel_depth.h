// How deep under its skin a point of a fruit lies, for a peeler.
#pragma once

#include <vector>

#include "generator/surface/skin_depth.h"

namespace pomona {

/// The skin is that of the fruit's main body: the shell that encloses most. Other bodies that stick out of it and are
/// longer than a tenth of it (stems, calyces) stay with the fruit, as a peeler leaves them.
class PeelDepth {
 public:
  /// `clearance`: metres around what stays within which nothing is peeled off.
  /// \throws Error (bad_data) for a fruit without a closed skin.
  PeelDepth(const DiffusionSurfaces& surfaces, double thickness, double clearance);

  struct Place {
    double depth = 0;      ///< metres below the skin, negative outside; what stays counts as deeper than the peel
    glm::dvec3 deeper{0};  ///< the direction in which the depth grows, unit length, or 0 where there is none
  };
  Place at(const glm::dvec3& point) const;

  /// Metres from what stays, or `within` if that is farther off.
  double from_what_stays(const glm::dvec3& point, double within) const;

  /// Metres below the skin, negative outside, as if nothing but the main body were there.
  double below_skin(const glm::dvec3& point) const;

  const TriangleTree& skin() const { return skin_.skin(); }
  /// Of the skin and of all that stays.
  const Box<double>& box() const { return box_; }

 private:
  SkinDepth skin_;
  std::vector<TriangleTree> stays_;
  double kept_ = 0;  ///< metres: the depth at the surface of what stays; farther off it is less by the distance
  Box<double> box_;
};

}  // namespace pomona
