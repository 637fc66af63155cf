// The solution at the nodes themselves, for the page that cuts a fruit in the browser (render/page).
#pragma once

#include <cstdint>
#include <vector>

#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// Values of all nodes of a lattice; node (x, y, z) has the index (z * count.y + y) * count.x + x.
struct NodeColors {
  Lattice lattice;
  std::vector<Color> color;         ///< linear; black where `known` is 0
  std::vector<std::uint8_t> known;  ///< 1 where the node takes part and some random walk from it ends on a surface
};

/// The grid that covers everything, from the field that make_harmonic_diffuser() solves with these options. Patches
/// around seeds improve this solution; they are not returned.
NodeColors solved_nodes(const DiffusionSurfaces& surfaces, const HarmonicOptions& options);

}  // namespace pomona
