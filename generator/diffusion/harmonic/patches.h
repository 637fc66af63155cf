// Where a grid is too coarse: around seeds and other small bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"

namespace pomona {

/// A connected part of the surfaces that is small against the whole.
struct SmallBody {
  std::vector<std::uint32_t> triangle;
  double half_thickness = 0;  ///< metres: 3 volume / area, the radius of a ball; 0 for sheets
};

/// All parts whose box is shorter than `longest` (metres) along its diagonal.
std::vector<SmallBody> small_bodies(const DiffusionSurfaces& surfaces, double longest);

/// The nodes of a finer lattice that cover some cells of a coarser one, border included.
struct PatchNodes {
  NodeRuns runs;
  std::vector<std::uint8_t> members;     ///< per run, a bit per node; others of a run are no part of the patch
  std::vector<std::uint8_t> is_covered;  ///< per brick of the coarser lattice
  std::vector<std::uint32_t> triangle;   ///< all that may meet it, ascending
};

/// Bricks of 4 x 2 x 2 cells of `coarse` within `margin` cells of the triangles; with `within`, those only that its
/// bricks (of the lattice before `coarse`) contain.
PatchNodes patch_around(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& coarse,
                        int margin, const PatchNodes* within);

}  // namespace pomona
