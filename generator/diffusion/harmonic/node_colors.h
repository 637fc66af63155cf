// The solution at the nodes themselves: what travels with a fruit to where it is cut (render/page).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// Of all nodes of a lattice: node (x, y, z) at (z * count.y + y) * count.x + x.
struct NodeColors {
  Lattice lattice;
  std::vector<Color> color;         ///< linear; black where it is not known
  std::vector<std::uint8_t> known;  ///< 1 where the node takes part and some walk from it ends on a surface
};

/// The grid that holds all, of the field that make_harmonic_diffuser() solves with these options; patches around seeds
/// have helped to solve it and are left behind.
NodeColors solved_nodes(const DiffusionSurfaces& surfaces, const HarmonicOptions& options);

}  // namespace pomona
