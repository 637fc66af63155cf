// A closed knife's surface, prepared for cutting: as fine as its cut faces should be, with smooth normals.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/closed_surface.h"

namespace pomona {

/// A closed surface as triangles that share points, each corner with the normal to shade it by.
struct KnifeMesh {
  struct Triangle {
    std::array<std::uint32_t, 3> corner{};  ///< points
    std::array<glm::dvec3, 3> normal{};  ///< per corner, unit, pointing outside; equal across edges that are no crease
    std::uint32_t face = 0;              ///< number of its face: triangles connected by edges that are no crease
  };
  std::vector<glm::dvec3> point;
  std::vector<Triangle> triangle;
  std::uint32_t faces = 0;

  std::array<glm::dvec3, 3> corners(std::size_t t) const {
    const std::array<std::uint32_t, 3>& c = triangle[t].corner;
    return {point[c[0]], point[c[1]], point[c[2]]};
  }
};

/// The surface with equal points merged, and without triangles of area 0. Creases: see crease.h.
/// \throws Error (bad_data) for a surface that is not closed; the message calls the knife by `name`.
KnifeMesh knife_mesh(const ClosedSurface& surface, const std::string& name);

/// The mesh with edges halved until none is longer than 1.4 times what `size` (metres) says at its middle.
KnifeMesh refined(KnifeMesh mesh, const std::function<double(const glm::dvec3&)>& size);

}  // namespace pomona
