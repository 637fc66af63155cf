// Crossings of lattice lines with triangles, decided exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// An arm between `node` and the next one along `axis` that a triangle cuts.
struct ArmCrossing {
  std::uint32_t triangle = 0;
  Node node{};
  int axis = 0;
  float theta = 0;                ///< from the node, in arms, 0..1
  std::array<float, 3> weight{};  ///< barycentric
  bool front_ahead = false;       ///< the node behind sees the back
};

/// All arms cut by some triangles with an end in a plane z in [first_z, end_z), each once per triangle.
///
/// The lattice is treated as moved by (e1, e2, e3), infinitely small, where e1 is much larger than e2, and e2 than e3.
/// Then no node lies on a triangle, and no line meets an edge; so every loop of arms crosses a closed surface an even
/// number of times [Edelsbrunner & Muecke 1990, Simulation of Simplicity]. All decisions use whole numbers.
std::vector<ArmCrossing> arm_crossings(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles,
                                       const Lattice& lattice, int first_z, int end_z);

}  // namespace pomona
