#include "render/marks/blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pomona {

namespace {

/// The mean of 2 `reach` + 1 neighbours of each of `count` numbers, which are `step` apart.
void box_filter(std::vector<float>& field, std::size_t first, std::size_t step, int count, int reach,
                std::vector<float>& row) {
  const auto value = [&](int i) { return row[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]; };
  for (int i = 0; i < count; ++i) row[static_cast<std::size_t>(i)] = field[first + static_cast<std::size_t>(i) * step];

  double sum = 0;
  for (int i = -reach; i <= reach; ++i) sum += value(i);
  for (int i = 0; i < count; ++i) {
    field[first + static_cast<std::size_t>(i) * step] = static_cast<float>(sum / (2 * reach + 1));
    sum += static_cast<double>(value(i + reach + 1)) - value(i - reach);
  }
}

}  // namespace

std::vector<float> blurred(std::vector<float> field, int width, int height, double deviation) {
  // Three boxes of 2 r + 1 have the variance r (r + 1).
  const int reach = static_cast<int>(std::floor((std::sqrt(1 + 4 * deviation * deviation) - 1) / 2 + 0.5));
  if (reach < 1 || field.empty()) return field;

  std::vector<float> row(static_cast<std::size_t>(std::max(width, height)));
  const auto w = static_cast<std::size_t>(width);
  for (int pass = 0; pass < 3; ++pass) {
    for (int y = 0; y < height; ++y) box_filter(field, static_cast<std::size_t>(y) * w, 1, width, reach, row);
    for (int x = 0; x < width; ++x) box_filter(field, static_cast<std::size_t>(x), w, height, reach, row);
  }
  return field;
}

}  // namespace pomona
