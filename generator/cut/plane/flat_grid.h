// A grid in the view along -Z, for what may lie on a straight line or a stretch of it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// Boxes and points by the cells that they meet.
class FlatGrid {
 public:
  /// A grid over [low, high], metres, with about as many cells as items are expected.
  FlatGrid(const glm::dvec2& low, const glm::dvec2& high, std::size_t items);

  /// Items outside the grid go to its nearest cells.
  void add(std::uint32_t item, const glm::dvec2& low, const glm::dvec2& high);
  void add(std::uint32_t item, const glm::dvec2& point) { add(item, point, point); }

  /// All items in the grid with a point within `margin`, metres, of a stretch, and others; in ascending order.
  std::vector<std::uint32_t> near(const glm::dvec2& from, const glm::dvec2& to, double margin) const;

 private:
  struct Entry {
    std::uint32_t item = 0, before = 0;  ///< previous entry of the same cell, or none
  };

  int column(double x) const { return cell_along(x, 0); }
  int row(double y) const { return cell_along(y, 1); }
  int cell_along(double place, int axis) const;
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(count_[0]) + static_cast<std::size_t>(column);
  }

  static constexpr std::uint32_t none = 0xffffffffu;
  glm::dvec2 low_, width_;  ///< of a cell
  glm::ivec2 count_;
  std::vector<std::uint32_t> newest_;  ///< per cell: its last entry
  std::vector<Entry> entries_;
};

}  // namespace pomona
