// Bodies: what is solid. Boundary triangles form shells; a body is an outer shell with the cavity walls
// inside it (the fruit, a stem, a seed in a hollow).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The body that each triangle bounds, and the properties of each body.
struct Bodies {
  static constexpr std::int32_t none = -1;

  std::vector<std::int32_t> of_triangle;  ///< body of each boundary triangle, `none` for inner ones
  struct Body {
    bool closed = true;  ///< every welded edge is matched by an opposite one
    double volume = 0;   ///< cubic metres; outer shell less cavities; 0 if open
    int shells = 0;
  };
  std::vector<Body> bodies;
  std::vector<std::string> warnings;  ///< "surface "skin" is open: pieces will be open there"
};

/// Finds shells after welding equal positions, and puts every cavity wall into the smallest outer shell that
/// contains it. A boundary triangle faces air with its hidden side.
/// \throws Error (bad_data) for a triangle with both sides hidden.
Bodies find_bodies(const DiffusionSurfaces& surfaces);

/// Area-weighted vertex normals of the front sides, found across vertices at equal positions; unit length,
/// zero where a vertex has no area.
std::vector<glm::vec3> vertex_normals(const DiffusionSurfaces& surfaces);

}  // namespace pomona
