// Tetrahedra between diffusion surfaces, whose faces the surfaces are made of (paper, Figure 4).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona::bench {

struct TetrahedralMesh {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<glm::dvec3> position;  ///< metres

  // One entry per tetrahedron; entry i of it is opposite corner i.
  std::vector<std::array<std::uint32_t, 4>> corner;
  std::vector<std::array<std::uint32_t, 4>> neighbor;  ///< `none` beyond the outer skin
  std::vector<std::array<bool, 4>> on_surface;         ///< whether that face is part of a diffusion surface
};

/// A mesh, or in plain words why there is none.
struct TetrahedralMeshing {
  std::optional<TetrahedralMesh> mesh;
  std::string why_not;
};

/// Delaunay refinement [CGAL, Mesh_3] of the space inside the outermost surface; the same mesh every time. One closed
/// surface must hold all others, and none may cross or touch another.
/// \param cell_size metres: about the longest edge; surfaces are approximated within a twentieth of it.
TetrahedralMeshing make_tetrahedral_mesh(const DiffusionSurfaces& surfaces, double cell_size);

}  // namespace pomona::bench
