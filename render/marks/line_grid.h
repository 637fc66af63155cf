// A grid of the points of lines, to find the distance to the next line.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// Points on a sheet in square cells, for questions that reach no farther than a cell.
class LineGrid {
 public:
  /// \param reach pixels: the farthest that is_free() will be asked for.
  LineGrid(int width, int height, double reach);

  /// \param step which point of its line this is, from where it began; the other way counts negative.
  void add(const glm::dvec2& place, int line, int step);

  /// Whether no point lies nearer than `distance`, but those of the same line within `own` steps.
  bool is_free(const glm::dvec2& place, double distance, int line, int step, int own) const;

 private:
  struct Entry {
    glm::dvec2 place;
    int line, step;
  };
  std::size_t cell(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }

  double reach_;
  int columns_, rows_;
  std::vector<std::vector<Entry>> cells_;
};

}  // namespace pomona
