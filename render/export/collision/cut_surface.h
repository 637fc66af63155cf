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
  std::vector<Corners> skin;   ///< of the solid itself
  std::vector<Corners> cones;  ///< of cut faces

  double volume() const;
  std::vector<glm::vec3> points() const;  ///< corners of the skin, each once, sorted: their hull is that of the part
  Box<double> box() const;                ///< around the skin
};

/// The part behind the plane and the part in front of it.
std::array<CutSurface, 2> divided(const CutSurface& surface, const CuttingPlane& plane);

}  // namespace pomona::collision
