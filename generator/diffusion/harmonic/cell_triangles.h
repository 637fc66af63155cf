// Which triangles lie in which cell of a lattice.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// The cell with its low corner at node (x, y, z) has the index (z * count.y + y) * count.x + x.
class CellTriangles {
 public:
  CellTriangles() = default;

  /// Cells count as larger by `margin`, in cells.
  CellTriangles(const SnappedSurfaces& snapped, const Lattice& lattice, double margin, Threads threads);

  /// All triangles that meet the cell, and few others; ascending.
  std::span<const std::uint32_t> in(std::size_t cell) const {
    return {triangle_.data() + first_[cell], triangle_.data() + first_[cell + 1]};
  }

  std::size_t bytes() const { return sizeof(std::uint32_t) * (first_.size() + triangle_.size()); }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> triangle_;
};

}  // namespace pomona
