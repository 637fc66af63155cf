#include "render/marks/stippling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "generator/base/random.h"

namespace pomona {

namespace {

/// Dots in square cells as wide as the smallest distance; the wanted distance decides how many cells are searched.
class DotGrid {
 public:
  DotGrid(int width, int height, double cell)
      : cell_(cell),
        columns_(static_cast<int>(width / cell) + 1),
        rows_(static_cast<int>(height / cell) + 1),
        cells_(static_cast<std::size_t>(columns_) * rows_) {}

  bool is_free(const glm::dvec2& place, double distance) const {
    const int reach = static_cast<int>(std::ceil(distance / cell_));
    const int column = static_cast<int>(place.x / cell_), row = static_cast<int>(place.y / cell_);
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, rows_ - 1); ++y) {
      for (int x = std::max(column - reach, 0); x <= std::min(column + reach, columns_ - 1); ++x) {
        for (const glm::dvec2& dot : cells_[static_cast<std::size_t>(y) * columns_ + x]) {
          const glm::dvec2 away = dot - place;
          if (glm::dot(away, away) < distance * distance) return false;
        }
      }
    }
    return true;
  }

  void add(const glm::dvec2& place) {
    const int column = static_cast<int>(place.x / cell_), row = static_cast<int>(place.y / cell_);
    cells_[static_cast<std::size_t>(row) * columns_ + column].push_back(place);
  }

 private:
  double cell_;
  int columns_, rows_;
  std::vector<std::vector<glm::dvec2>> cells_;
};

}  // namespace

std::vector<Mark> stippled(const ToneMap& tones, const StippleOptions& options) {
  const double radius = 0.5 * options.width, closest = 1.48 * radius;
  const RandomStream draw({}, "stipple");
  DotGrid grid(tones.width, tones.height, closest);

  // Some thirty tries for every dot of the densest packing.
  const auto tries = static_cast<std::uint64_t>(20.0 * tones.width * tones.height / (closest * closest));
  std::vector<Mark> dots;
  for (std::uint64_t i = 0; i < tries; ++i) {
    const glm::dvec2 place(draw.uniform(3 * i) * tones.width, draw.uniform(3 * i + 1) * tones.height);
    const double dark = tones.at(place);
    if (dark <= options.lightest || !grid.is_free(place, closest / std::sqrt(dark))) continue;
    grid.add(place);
    dots.push_back({{place, radius * (0.8 + 0.4 * draw.uniform(3 * i + 2))}});
  }
  return dots;
}

}  // namespace pomona
