// Which darts lie near a place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// Balls in cells of space. Each has a diameter of its own; two of them meet if their centres are nearer than the
/// mean of their diameters. Balls of like diameter share a level, whose cells are about as wide.
class DartCells {
 public:
  /// `width` of the finest cells: the smallest usual diameter.
  explicit DartCells(double width) : width_(width) {}

  void add(const glm::dvec3& center, double diameter, std::size_t index) {
    const std::size_t at = level_of(diameter);
    if (levels_.size() <= at) levels_.resize(at + 1);
    levels_[at].largest = std::max(levels_[at].largest, diameter);
    levels_[at].indices.emplace(cell_of(center, width_of(at)), index);
  }

  /// True if the question is answered with yes for any ball that may meet the given one.
  template <typename Question>
  bool any_meets(const glm::dvec3& center, double diameter, const Question& question) const {
    for (std::size_t at = 0; at < levels_.size(); ++at) {
      const Level& level = levels_[at];
      if (level.indices.empty()) continue;
      const double width = width_of(at);
      const auto reach = static_cast<std::int64_t>(std::ceil(0.5 * (diameter + level.largest) / width));
      const Cell cell = cell_of(center, width);
      for (std::int64_t x = cell[0] - reach; x <= cell[0] + reach; ++x) {
        for (std::int64_t y = cell[1] - reach; y <= cell[1] + reach; ++y) {
          const Cell last{x, y, cell[2] + reach};
          const auto from = level.indices.lower_bound(Cell{x, y, cell[2] - reach});
          for (auto it = from; it != level.indices.end() && it->first <= last; ++it) {
            if (question(it->second)) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Level {
    double largest = 0;  ///< diameter
    std::multimap<Cell, std::size_t> indices;
  };

  double width_of(std::size_t level) const { return width_ * static_cast<double>(std::uint64_t{1} << level); }

  std::size_t level_of(double diameter) const {
    std::size_t level = 0;
    while (level < 40 && diameter >= 2 * width_of(level)) ++level;
    return level;
  }

  static Cell cell_of(const glm::dvec3& p, double width) {
    Cell cell;
    for (int k = 0; k < 3; ++k) {
      cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / width));
    }
    return cell;
  }

  double width_;
  std::vector<Level> levels_;
};

}  // namespace pomona
