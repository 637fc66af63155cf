#include "generator/cut/plane/flat_grid.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace pomona {

namespace {

constexpr double max_cells = 1024;  // along an axis

}  // namespace

FlatGrid::FlatGrid(const glm::dvec2& low, const glm::dvec2& high, std::size_t items) : low_(low) {
  const double cells = std::clamp(std::ceil(std::sqrt(static_cast<double>(items))), 1.0, max_cells);
  const glm::dvec2 size = high - low;
  for (int axis = 0; axis < 2; ++axis) {
    count_[axis] = size[axis] > 0 ? static_cast<int>(cells) : 1;
    width_[axis] = size[axis] > 0 ? size[axis] / cells : 1;
  }
  newest_.assign(cell(0, count_[1]), none);
}

int FlatGrid::cell_along(double place, int axis) const {
  const double at = std::floor((place - low_[axis]) / width_[axis]);
  return static_cast<int>(std::clamp(at, 0.0, count_[axis] - 1.0));
}

void FlatGrid::add(std::uint32_t item, const glm::dvec2& low, const glm::dvec2& high) {
  for (int y = row(low.y); y <= row(high.y); ++y) {
    for (int x = column(low.x); x <= column(high.x); ++x) {
      entries_.push_back({item, newest_[cell(x, y)]});
      newest_[cell(x, y)] = static_cast<std::uint32_t>(entries_.size() - 1);
    }
  }
}

std::vector<std::uint32_t> FlatGrid::near(const glm::dvec2& from, const glm::dvec2& to, double margin) const {
  const glm::dvec2 low = glm::min(from, to) - margin, high = glm::max(from, to) + margin, way = to - from;
  std::vector<std::uint32_t> found;
  for (int x = column(low.x); x <= column(high.x); ++x) {
    // The part of the stretch that runs over the column; outermost columns have all that lies beyond.
    double begin = 0, end = 1;
    const double left = low_.x + x * width_.x - margin, right = low_.x + (x + 1) * width_.x + margin;
    if (std::fabs(way.x) > margin && x > 0 && x + 1 < count_[0]) {
      const double a = (left - from.x) / way.x, b = (right - from.x) / way.x;
      begin = std::clamp(std::min(a, b), 0.0, 1.0);
      end = std::clamp(std::max(a, b), 0.0, 1.0);
    }
    const double at_begin = from.y + begin * way.y, at_end = from.y + end * way.y;
    const int last = row(std::max(at_begin, at_end) + margin);
    for (int y = row(std::min(at_begin, at_end) - margin); y <= last; ++y)
      for (std::uint32_t i = newest_[cell(x, y)]; i != none; i = entries_[i].before) found.push_back(entries_[i].item);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace pomona
