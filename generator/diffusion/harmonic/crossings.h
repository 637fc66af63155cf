// Where the lines of a lattice cross triangles, decided exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// A link between `node` and the next one along `axis` that a triangle cuts.
struct LinkCrossing {
  std::uint32_t triangle = 0;
  Node node{};
  int axis = 0;
  float theta = 0;                ///< from the node, in links, 0..1
  std::array<float, 3> weight{};  ///< barycentric
  bool front_ahead = false;       ///< the node behind sees the back
};

/// All links cut by some triangles with an end in a plane z in [first_z, end_z), each once per triangle.
///
/// The lattice counts as moved by (e1, e2, e3), infinitely small, e1 far above e2 far above e3: then no node lies on a
/// triangle and no line meets an edge, and every loop of links crosses a closed surface an even number of times
/// [Edelsbrunner & Muecke 1990, Simulation of Simplicity]. All decisions are made in whole numbers.
std::vector<LinkCrossing> link_crossings(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles,
                                         const Lattice& lattice, int first_z, int end_z);

}  // namespace pomona
