// Which triangles lie in which cell of a lattice.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"

namespace pomona {

/// Some of many numbered things, and the place of each of them among these.
class SparseSet {
 public:
  SparseSet() = default;
  explicit SparseSet(std::size_t all) : words_((all + 63) / 64) {}

  void add(std::size_t i) { words_[i / 64].bits |= std::uint64_t{1} << i % 64; }
  void add_all(const SparseSet& others, std::size_t first);  ///< their number 0 is `first` here

  /// Counts them, which place() needs; how many there are.
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
    std::uint32_t before = 0;  ///< how many lie in words before this one
  };
  std::vector<Word> words_;
};

/// The cell with its low corner at node (x, y, z) has the index (z * count.y + y) * count.x + x.
class CellTriangles {
 public:
  CellTriangles() = default;

  /// All triangles that meet the cell, and few others; ascending.
  std::span<const std::uint32_t> in(std::size_t cell) const {
    if (!filled_.holds(cell)) return {};
    const std::uint32_t place = filled_.place(cell);
    return {triangle_.data() + first_[place], triangle_.data() + first_[place + 1]};
  }

  std::size_t bytes() const { return filled_.bytes() + sizeof(std::uint32_t) * (first_.size() + triangle_.size()); }

 private:
  friend class CellTriangleFinder;
  SparseSet filled_;                  ///< most cells hold none
  std::vector<std::uint32_t> first_;  ///< per filled cell
  std::vector<std::uint32_t> triangle_;
};

/// Finds them slab by slab, in two rounds whose items threads may share with other work: find(i) for every slab, one
/// place(), fill(i) for every slab.
class CellTriangleFinder {
 public:
  /// Cells count as larger by `margin`, in cells. `snapped` is read until the last find(), `lattice` until place().
  CellTriangleFinder(const SnappedSurfaces& snapped, const Lattice& lattice, double margin);

  std::size_t slab_count() const { return slabs_.size(); }
  void find(std::size_t slab);
  void place();
  void fill(std::size_t slab);
  CellTriangles taken() { return std::move(cells_); }

 private:
  /// What lies in some layers of cells.
  struct Slab {
    std::pair<int, int> layers;
    std::vector<std::uint32_t> near;  ///< triangles that may meet it
    std::size_t first_cell = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> entry;  ///< cell, from the first on, and triangle; as found
    SparseSet filled;                                            ///< of its cells
    std::uint32_t filled_count = 0;
    std::uint32_t filled_before = 0, entries_before = 0;  ///< in the slabs before it
  };
  void add_cells_of(std::uint32_t triangle, Slab& slab) const;

  const SnappedSurfaces& snapped_;
  const Lattice& lattice_;
  double margin_;
  std::size_t plane_;  ///< cells of a layer
  std::vector<Slab> slabs_;
  CellTriangles cells_;
};

}  // namespace pomona
