// The depth of a point below the skin of a fruit, for a peeler.
#pragma once

#include <vector>

#include "generator/surface/skin_depth.h"

namespace pomona {

/// The skin is that of the fruit's main body: the shell with the largest volume. Other bodies that stick out of it and
/// are longer than a tenth of it (stems, calyces) are kept: a peeler leaves them on the fruit.
class PeelDepth {
 public:
  /// \param thickness of the peel, metres.
  /// \param clearance nothing is peeled off within this distance of a kept body, metres.
  /// \throws Error (bad_data) for a fruit without a closed skin, (usage) for one of many bodies: those that would be
  /// kept have together more volume than the main body.
  PeelDepth(const DiffusionSurfaces& surfaces, double thickness, double clearance);

  struct Place {
    double depth = 0;      ///< metres below the skin, negative outside; kept bodies count as deeper than the peel
    glm::dvec3 deeper{0};  ///< the direction in which the depth grows, of length 1; 0 if there is none
  };
  Place at(const glm::dvec3& point) const;

  /// The distance from the kept bodies, metres, if it is below `within`; else `within`.
  double from_what_stays(const glm::dvec3& point, double within) const;

  /// The depth below the skin of the main body alone, metres, negative outside.
  double below_skin(const glm::dvec3& point) const;

  const TriangleTree& skin() const { return skin_.skin(); }
  /// The box of the skin and of the kept bodies.
  const Box<double>& box() const { return box_; }

 private:
  SkinDepth skin_;
  std::vector<TriangleTree> stays_;
  double kept_ = 0;  ///< depth at the surface of a kept body, metres; it decreases with the distance from it
  Box<double> box_;
};

}  // namespace pomona
