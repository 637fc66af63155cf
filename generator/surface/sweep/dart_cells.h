// A grid of balls, to find the darts near a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// Balls in the cells of hashed grids. Each ball has a diameter of its own; two balls meet if their centres are nearer
/// than the mean of their diameters. Balls of similar diameter share a level, whose cells are so wide that all balls
/// that meet a given one lie in few cells.
class DartCells {
 public:
  /// \param width the smallest usual diameter, metres.
  explicit DartCells(double width) : width_(width) {}

  void add(const glm::dvec3& center, double diameter, std::size_t index) {
    const std::size_t at = level_of(diameter);
    if (levels_.size() <= at) levels_.resize(at + 1);
    levels_[at].largest = std::max(levels_[at].largest, diameter);
    levels_[at].cells.add(cell_of(center, width_of(at)), {center, diameter, index});
  }

  void clear() { levels_.clear(); }

  /// True if question(ball) is true for any ball that may meet the given one.
  template <typename Question>
  bool any_meets(const glm::dvec3& center, double diameter, const Question& question) const {
    for (std::size_t at = 0; at < levels_.size(); ++at) {
      const Level& level = levels_[at];
      if (level.cells.empty()) continue;
      const double width = width_of(at);
      const double reach = margin * 0.5 * (diameter + level.largest);
      const auto meets = [&](const Ball& ball) {
        const double mean = 0.5 * (diameter + ball.diameter);
        const glm::dvec3 away = ball.center - center;
        return glm::dot(away, away) < margin * mean * mean && question(ball.index);
      };
      if (any_between(level.cells, cell_of(center - reach, width), cell_of(center + reach, width), meets)) return true;
    }
    return false;
  }

 private:
  struct Cell {
    std::int64_t x = 0, y = 0, z = 0;
    bool operator==(const Cell&) const = default;
  };

  /// Balls that are a little farther apart are tested, too: the caller decides exactly.
  static constexpr double margin = 1.002;

  struct Ball {
    glm::dvec3 center;
    double diameter;
    std::size_t index;
  };

  /// The balls of each cell, hashed: chains of entries, the last added first.
  class Cells {
   public:
    bool empty() const { return entries_.empty(); }

    void add(const Cell& cell, const Ball& ball) {
      entries_.push_back({cell, ball, none});
      if (entries_.size() > newest_.size()) return rehash();
      chain(static_cast<std::uint32_t>(entries_.size() - 1));
    }

    template <typename Question>
    bool any_in(const Cell& cell, const Question& question) const {
      for (std::uint32_t i = newest_[place_of(cell)]; i != none; i = entries_[i].before) {
        if (entries_[i].cell == cell && question(entries_[i].ball)) return true;
      }
      return false;
    }

   private:
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Entry {
      Cell cell;
      Ball ball;
      std::uint32_t before;  ///< previous entry of the same place in the table
    };

    std::size_t place_of(const Cell& cell) const {
      std::uint64_t hash = 0;
      for (const std::int64_t at : {cell.x, cell.y, cell.z})
        hash = (hash ^ static_cast<std::uint64_t>(at)) * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(hash >> 32) & (newest_.size() - 1);
    }

    void chain(std::uint32_t entry) {
      std::uint32_t& newest = newest_[place_of(entries_[entry].cell)];
      entries_[entry].before = newest;
      newest = entry;
    }

    /// The table with room for four times as many.
    void rehash() {
      newest_.assign(std::max<std::size_t>(64, 4 * newest_.size()), none);
      for (std::size_t i = 0; i < entries_.size(); ++i) chain(static_cast<std::uint32_t>(i));
    }

    std::vector<Entry> entries_;
    std::vector<std::uint32_t> newest_;  ///< per hash; as many as a power of two
  };

  struct Level {
    double largest = 0;  ///< diameter
    Cells cells;
  };

  template <typename Question>
  static bool any_between(const Cells& cells, const Cell& low, const Cell& high, const Question& question) {
    for (std::int64_t x = low.x; x <= high.x; ++x)
      for (std::int64_t y = low.y; y <= high.y; ++y)
        for (std::int64_t z = low.z; z <= high.z; ++z)
          if (cells.any_in({x, y, z}, question)) return true;
    return false;
  }

  /// The width of a level's cells: no ball in it is wider.
  double width_of(std::size_t level) const { return 2 * width_ * static_cast<double>(std::uint64_t{1} << level); }

  std::size_t level_of(double diameter) const {
    std::size_t level = 0;
    while (level < 40 && diameter >= width_of(level)) ++level;
    return level;
  }

  static Cell cell_of(const glm::dvec3& p, double width) {
    const auto at = [&](double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate / width)); };
    return {at(p.x), at(p.y), at(p.z)};
  }

  double width_;
  std::vector<Level> levels_;
};

}  // namespace pomona
