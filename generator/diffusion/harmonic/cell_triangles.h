// For each cell of a lattice: the triangles in it.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"

namespace pomona {

/// A subset of the numbers 0 to all - 1, stored as bits. place() gives the index of a member among the members.
class SparseSet {
 public:
  SparseSet() = default;
  explicit SparseSet(std::size_t all) : words_((all + 63) / 64) {}

  void add(std::size_t i) { words_[i / 64].bits |= std::uint64_t{1} << i % 64; }
  /// Adds every number of `others`, moved up by `first`.
  void add_all(const SparseSet& others, std::size_t first);

  /// Prepares place(). Returns the number of members.
  std::uint32_t count();

  bool holds(std::size_t i) const { return words_[i / 64].bits >> i % 64 & 1; }
  std::uint32_t place(std::size_t i) const {
    const Word& word = words_[i / 64];
    return word.before + count_of_bits(word.bits & ((std::uint64_t{1} << i % 64) - 1));
  }
  std::size_t bytes() const { return words_.size() * sizeof(Word); }

 private:
  struct Word {
    std::uint64_t bits = 0;
    std::uint32_t before = 0;  ///< number of members in the words before this one
  };
  std::vector<Word> words_;
};

/// The cell with its low corner at node (x, y, z) has the index (z * count.y + y) * count.x + x.
class CellTriangles {
 public:
  CellTriangles() = default;

  /// All triangles that meet the cell, and few others; sorted.
  std::span<const std::uint32_t> in(std::size_t cell) const {
    if (!filled_.holds(cell)) return {};
    const std::uint32_t place = filled_.place(cell);
    return {triangle_.data() + first_[place], triangle_.data() + first_[place + 1]};
  }

  std::size_t bytes() const { return filled_.bytes() + sizeof(std::uint32_t) * (first_.size() + triangle_.size()); }

 private:
  friend class CellTriangleFinder;
  SparseSet filled_;                     ///< the cells with triangles; most cells have none
  std::vector<std::uint32_t> first_;     ///< per filled cell: index of its first triangle in triangle_
  std::vector<std::uint32_t> triangle_;  ///< the triangles of all filled cells, cell by cell
};

/// Finds the triangles slab by slab. Call find(i) for every slab, then place() once, then fill(i) for every slab. The
/// calls for different slabs may run in parallel, also beside other work.
class CellTriangleFinder {
 public:
  /// \param margin each cell is enlarged by this on every side, in cells.
  /// `snapped` must live until the last find(), `lattice` until place().
  CellTriangleFinder(const SnappedSurfaces& snapped, const Lattice& lattice, double margin);

  std::size_t slab_count() const { return slabs_.size(); }
  void find(std::size_t slab);
  void place();
  void fill(std::size_t slab);
  CellTriangles taken() { return std::move(cells_); }

 private:
  /// Some layers of cells.
  struct Slab {
    std::pair<int, int> layers;                                  ///< z of the first, and of the one after the last
    std::vector<std::uint32_t> near;                             ///< triangles that may meet the slab
    std::size_t first_cell = 0;                                  ///< index of its first cell
    std::vector<std::pair<std::uint32_t, std::uint32_t>> entry;  ///< (cell - first_cell, triangle), in any order
    SparseSet filled;                                            ///< cells with triangles, counted from first_cell
    std::uint32_t filled_count = 0;                              ///< number of filled cells
    std::uint32_t filled_before = 0;                             ///< number of filled cells in the slabs before
    std::uint32_t entries_before = 0;                            ///< number of entries in the slabs before
  };
  void add_cells_of(std::uint32_t triangle, Slab& slab) const;

  const SnappedSurfaces& snapped_;
  const Lattice& lattice_;
  double margin_;
  std::size_t plane_;  ///< number of cells in a layer
  std::vector<Slab> slabs_;
  CellTriangles cells_;
};

}  // namespace pomona
