// Finer patches of a grid, where it is too coarse: around seeds and other small bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"

namespace pomona {

/// Patches consist of bricks. A brick has this many cells of the coarser lattice along each axis.
constexpr Node brick{4, 2, 2};

/// The number of bricks of a lattice along each axis; the index of a brick among all.
Node bricks_of(const Lattice& lattice);
std::size_t brick_index(const Node& at, const Node& count);

/// A connected part of the surfaces that is much smaller than the whole.
struct SmallBody {
  std::vector<std::uint32_t> triangle;  ///< indices of its triangles
  double half_thickness = 0;            ///< metres: 3 volume / area, the radius of a ball; 0 for sheets
};

/// All connected parts whose box has a diagonal shorter than `longest`, metres.
std::vector<SmallBody> small_bodies(const DiffusionSurfaces& surfaces, double longest);

/// The nodes of a finer lattice that cover some cells of a coarser one, with their border.
struct PatchNodes {
  SparseBlocks blocks;
  std::vector<std::uint8_t> members;     ///< per block, a bit for each node that belongs to the patch
  std::vector<std::uint8_t> is_covered;  ///< per brick of the coarser lattice
  std::vector<std::uint32_t> triangle;   ///< all triangles that may meet the patch, sorted
};

/// The patch that covers the bricks of `coarse` within `margin` cells of the triangles.
/// \param within only bricks inside this patch (of the lattice before `coarse`) are covered; null = no limit.
/// \param wanted more bricks to cover: a mark for each brick, or empty.
PatchNodes patch_around(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& coarse,
                        int margin, const PatchNodes* within, std::span<const std::uint8_t> wanted = {});

}  // namespace pomona
