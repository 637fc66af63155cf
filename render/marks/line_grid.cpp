#include "render/marks/line_grid.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

LineGrid::LineGrid(int width, int height, double reach)
    : reach_(reach),
      columns_(static_cast<int>(width / reach) + 1),
      rows_(static_cast<int>(height / reach) + 1),
      cells_(static_cast<std::size_t>(columns_) * rows_) {}

void LineGrid::add(const glm::dvec2& place, int line, int step) {
  const int column = std::clamp(static_cast<int>(std::floor(place.x / reach_)), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(std::floor(place.y / reach_)), 0, rows_ - 1);
  cells_[cell(column, row)].push_back({place, line, step});
}

bool LineGrid::is_free(const glm::dvec2& place, double distance, int line, int step, int own) const {
  const int column = static_cast<int>(std::floor(place.x / reach_)),
            row = static_cast<int>(std::floor(place.y / reach_));
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x) {
      for (const Entry& entry : cells_[cell(x, y)]) {
        if (entry.line == line && std::abs(entry.step - step) <= own) continue;
        const glm::dvec2 away = entry.place - place;
        if (glm::dot(away, away) < distance * distance) return false;
      }
    }
  }
  return true;
}

}  // namespace pomona
