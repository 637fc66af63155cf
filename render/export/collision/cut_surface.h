// Closed surfaces cut by planes, without a triangulation of what is cut.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/knife/knife.h"
#include "generator/mesh/box.h"

namespace pomona::collision {

using Corners = std::array<glm::dvec3, 3>;

/// The surface of a part of a solid. Where planes have cut the solid, cones close it: triangles from one point of the
/// plane to each edge there, some of them turned over. They do not show the cut face, but add up to it, so that volumes
/// are exact.
struct CutSurface {
  std::vector<Corners> skin;            ///< of the solid itself
  std::vector<Corners> cones;           ///< of cut faces
  std::vector<CuttingPlane> cuts;       ///< the part lies behind each
  std::vector<glm::dvec3> cut_corners;  ///< where three cuts meet within the solid: corners of the part off the skin

  double volume() const;
  std::vector<glm::vec3> points() const;  ///< corners of skin and cuts, each once, sorted: their hull is the part's
  Box<double> box() const;                ///< around the skin
  bool contains(const glm::dvec3& point) const;
};

/// The part behind the plane and the part in front of it.
std::array<CutSurface, 2> divided(const CutSurface& surface, const CuttingPlane& plane);

}  // namespace pomona::collision
