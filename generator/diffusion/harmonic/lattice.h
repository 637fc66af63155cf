// The nodes of a grid, and the surfaces in whole units of that grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A node's coordinates: whole numbers of spacings along x, y and z.
using Node = std::array<int, 3>;

/// Nodes at origin + spacing * (x, y, z), 0 <= x < count. A spacing is 2^unit_bits units; whether two things touch is
/// decided in whole units.
struct Lattice {
  glm::dvec3 origin{0};  ///< metres
  double spacing = 0;    ///< distance between neighbours, metres
  Node count{};          ///< number of nodes along each axis
  int unit_bits = 0;     ///< log2 of the units in a spacing

  std::int64_t units() const { return std::int64_t{1} << unit_bits; }
  double unit() const { return spacing / static_cast<double>(units()); }  ///< metres
};

/// unit_bits of the grid that covers everything: units are finer than the floats of vertices. A lattice has at most
/// 2^10 nodes along an axis, with the widest margins, so that coordinates stay below 2^29 and areas of triangles below
/// 2^60.
constexpr int base_unit_bits = 19;
constexpr int max_cells = 480;  ///< along an axis of the surfaces' box

/// A lattice around `surfaces`. Its counts are 1 + a multiple of 2^`halvings`.
/// \param spacing wanted, metres; the real one is about this.
/// \param margin the smallest number of cells around the surfaces, >= 1.
/// \param shift moves the lattice, in cells.
Lattice lattice_around(const DiffusionSurfaces& surfaces, double spacing, int margin, int halvings,
                       const glm::dvec3& shift);

/// The same lattice with half the spacing, and with twice the spacing.
Lattice halved(const Lattice& lattice);
Lattice doubled(const Lattice& lattice);

/// Surfaces whose vertices are rounded to whole units. Equal positions stay equal, so closed surfaces stay closed.
struct SnappedSurfaces {
  const DiffusionSurfaces* surfaces = nullptr;
  std::vector<std::array<std::int64_t, 3>> position;  ///< position of each vertex, in units from the origin
};
SnappedSurfaces snapped(const DiffusionSurfaces& surfaces, const Lattice& lattice);

}  // namespace pomona
