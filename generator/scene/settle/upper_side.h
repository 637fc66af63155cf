// What of a dish looks upwards: where pieces can be strewn.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/scene/settle/mesh_dish.h"

namespace pomona {

/// The triangles of a mesh that look upwards, to draw places on.
class UpperSide {
 public:
  /// \param form of the dish; without one there are none.
  UpperSide(const TriangleTree& mesh, const MeshDish* form);
  bool empty() const { return area_.empty(); }

  struct Spot {
    glm::dvec3 at, normal;
  };
  /// By three draws from 0 to 1: each share of the area is as likely.
  Spot spot(double share, double u, double v) const;

 private:
  std::vector<TriangleTree::Corners> corners_;
  std::vector<double> area_;  ///< of all up to here
};

}  // namespace pomona
