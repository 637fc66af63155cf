// Where a grid is too coarse: around seeds and other small bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"

namespace pomona {

/// Patches consist of bricks: so many cells of the coarser lattice along each axis.
constexpr Node brick{4, 2, 2};

/// How many bricks a lattice has along each axis, and a brick's place among all.
Node bricks_of(const Lattice& lattice);
std::size_t brick_index(const Node& at, const Node& count);

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

/// Bricks of `coarse` within `margin` cells of the triangles, and those of `wanted` (a mark for each, or empty); with
/// `within`, those only that its bricks (of the lattice before `coarse`) contain.
PatchNodes patch_around(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& coarse,
                        int margin, const PatchNodes* within, std::span<const std::uint8_t> wanted = {});

}  // namespace pomona
