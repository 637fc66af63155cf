// The part of a dish that faces upwards: pieces can be scattered on it.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/scene/settle/mesh_dish.h"

namespace pomona {

/// The triangles of a mesh that face upwards, for random places on them.
class UpperSide {
 public:
  /// \param form of the dish; without one there are no triangles.
  UpperSide(const TriangleTree& mesh, const MeshDish* form);
  bool empty() const { return area_.empty(); }

  struct Spot {
    glm::dvec3 at;      ///< metres
    glm::dvec3 normal;  ///< normal of the triangle, of length 1
  };
  /// A point from three random numbers in [0, 1): uniform by area.
  Spot spot(double share, double u, double v) const;

 private:
  std::vector<TriangleTree::Corners> corners_;
  std::vector<double> area_;  ///< sum of the areas of all triangles up to this one, square metres
};

}  // namespace pomona
