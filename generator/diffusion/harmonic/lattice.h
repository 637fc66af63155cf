// Where the nodes of a grid lie, and the surfaces in whole units of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A node's place: how many steps along x, y and z.
using Node = std::array<int, 3>;

/// Nodes at origin + spacing * (x, y, z), 0 <= x < count. Between neighbours lie 2^unit_bits units, and what
/// touches what is decided in whole units.
struct Lattice {
  glm::dvec3 origin{0};  ///< metres
  double spacing = 0;    ///< metres
  Node count{};
  int unit_bits = 0;

  std::int64_t units() const { return std::int64_t{1} << unit_bits; }
  double unit() const { return spacing / static_cast<double>(units()); }  ///< metres
};

/// Units between neighbours of the coarsest lattice that is not a multigrid's aid: finer than the floats that vertices
/// come from. A lattice has at most 2^10 nodes along an axis, the widest margins included, so that coordinates keep
/// below 2^29, and areas of triangles below 2^60.
constexpr int base_unit_bits = 19;
constexpr int most_cells = 480;  ///< along an axis of the surfaces' box

/// The lattice of spacing about `spacing` around `surfaces`: counts are 1 + a multiple of 2^`halvings`, with at
/// least `margin` (>= 1) cells around them; `shift`, in cells, moves it.
Lattice lattice_around(const DiffusionSurfaces& surfaces, double spacing, int margin, int halvings,
                       const glm::dvec3& shift);

/// The same with a node in the middle of every link; and with every other node only.
Lattice halved(const Lattice& lattice);
Lattice doubled(const Lattice& lattice);

/// The vertices of surfaces in units from the origin, rounded. Vertices at one place stay at one place, so what
/// is closed stays closed.
struct SnappedSurfaces {
  const DiffusionSurfaces* surfaces = nullptr;
  std::vector<std::array<std::int64_t, 3>> position;
};
SnappedSurfaces snapped(const DiffusionSurfaces& surfaces, const Lattice& lattice);

}  // namespace pomona
