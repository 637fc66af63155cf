// A closed knife's surface made ready for cutting: as fine as its cut faces should be, with smooth normals.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/closed_surface.h"

namespace pomona {

struct KnifeMesh {
  struct Triangle {
    std::array<std::uint32_t, 3> corner{};  ///< points
    std::array<glm::dvec3, 3> normal{};     ///< per corner, unit, pointing outside; the same where edges are no creases
    std::uint32_t face = 0;                 ///< triangles that hang together across such edges belong to one face
  };
  std::vector<glm::dvec3> point;
  std::vector<Triangle> triangle;
  std::uint32_t faces = 0;

  std::array<glm::dvec3, 3> corners(std::size_t t) const {
    const std::array<std::uint32_t, 3>& c = triangle[t].corner;
    return {point[c[0]], point[c[1]], point[c[2]]};
  }
};

/// Welded at equal positions.
/// \throws Error (bad_data) for a solid that is not closed; it is called by `name`.
KnifeMesh knife_mesh(const ClosedSurface& solid, const std::string& name);

/// With edges halved until none is much longer than `size` says at its middle.
KnifeMesh refined(KnifeMesh mesh, const std::function<double(const glm::dvec3&)>& size);

}  // namespace pomona
