// The vector code of the sweep over lines, compiled for plain x86-64, SSE4, AVX2 and AVX-512 and chosen when
// the program runs (Highway). All give the same bits: no fused operations, no sums across lanes, and no
// decision that depends on the width of a vector.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "generator/diffusion/pmvc/aligned_array.h"
#include "generator/diffusion/pmvc/group_boxes.h"
#include "generator/diffusion/pmvc/line_directions.h"
#include "generator/diffusion/pmvc/packed_surfaces.h"

namespace pomona {

/// The nearest hits in one direction along a line, one entry per slot.
struct SweepHits {
  AlignedFloats distance;  ///< normalised; infinity where there is none
  AlignedInts side;        ///< 2 * triangle, + 1 if its front looks along the line
  AlignedFloats second;    ///< barycentric coordinate of the second corner
  AlignedFloats third;
};

/// A grid of bins over the projected points. Points are renumbered bin by bin, row by row: those numbers are
/// slots, and the bins of a row that a triangle touches are one range of them.
struct SweepBins {
  float low_u = 0, low_v = 0;    ///< low corner of the grid
  float high_u = 0, high_v = 0;  ///< high corner of the grid
  float per_u = 0, per_v = 0;    ///< bins per length
  std::int32_t columns = 1, rows = 1;
  std::vector<std::int32_t> first_slot;  ///< columns * rows + 1
};

/// How far the points of each cell of a few bins see: what lies wholly outside [nearest, farthest] along the line is
/// hidden from all points there. Level k holds, for every cell, the square of 2^k x 2^k cells that begins there, so
/// that one entry serves a box of any size.
struct SweepReach {
  static constexpr int log_bins_per_cell = 2;
  static constexpr int bins_per_cell = 1 << log_bins_per_cell;  ///< along u
  std::vector<float> nearest, farthest;                         ///< levels x rows of bins x columns
  std::int32_t columns = 1, cells = 1, levels = 1;
};

/// The data of the vector code. Arrays of numbers are one vector longer than their entries.
struct SweepState {
  static constexpr std::size_t padding = 16;

  std::size_t points = 0;
  AlignedFloats x, y, z;  ///< the points, normalised
  AlignedFloats u, v, w;  ///< the same in the frame of the line
  AlignedInts bin;        ///< bin of every point

  SweepBins bins;
  AlignedFloats slot_u, slot_v, slot_w;
  std::vector<std::int32_t> point_of_slot;
  SweepHits ahead, behind;
  SweepReach reach;
};

/// Fills u, v, w.
void project_points(const Line& line, SweepState& state);

/// Fills bin, by bins.
void find_bins(SweepState& state);

/// Tests the triangles of boxes [first, end) against the slots that they cover, keeps the nearest hits ahead and
/// behind, and leaves out hidden boxes. `first` is a multiple of TriangleGroup::size.
void cover(const Line& line, const GroupBoxes& boxes, std::size_t first, std::size_t end,
           std::span<const TriangleGroup> groups, SweepState& state);

}  // namespace pomona
