#include "render/export/pov_palette.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pomona::pov {

namespace {

constexpr std::size_t finish_axis = 3;

/// Colours, by their numbers, in a box, and along which axis that is longest.
struct ColorBox {
  std::vector<std::size_t> colors;
  std::size_t axis = 0;
  long length = 0;
};

ColorBox box_around(std::vector<std::size_t> colors, const std::vector<FinishedColor>& all) {
  ColorBox box{std::move(colors), 0, 0};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    int low = all[box.colors.front()][axis], high = low;
    for (const std::size_t c : box.colors) {
      low = std::min(low, all[c][axis]);
      high = std::max(high, all[c][axis]);
    }
    // Divides finishes before colours.
    const long length = static_cast<long>(high - low) * (axis == finish_axis ? 1000 : 1);
    if (length > box.length) box.axis = axis, box.length = length;
  }
  return box;
}

/// Two boxes, divided at the middle between the ends, so that rare colours survive beside common ones.
std::pair<ColorBox, ColorBox> parted(const ColorBox& box, const std::vector<FinishedColor>& all) {
  int low = all[box.colors.front()][box.axis], high = low;
  for (const std::size_t c : box.colors) {
    low = std::min(low, all[c][box.axis]);
    high = std::max(high, all[c][box.axis]);
  }
  std::vector<std::size_t> lower, upper;
  for (const std::size_t c : box.colors) (2 * all[c][box.axis] <= low + high ? lower : upper).push_back(c);
  return {box_around(std::move(lower), all), box_around(std::move(upper), all)};
}

FinishedColor middle_of(const ColorBox& box, const std::vector<FinishedColor>& all) {
  std::array<long, 4> sum{};
  for (const std::size_t c : box.colors)
    for (std::size_t axis = 0; axis < 4; ++axis) sum[axis] += all[c][axis];
  const long count = static_cast<long>(box.colors.size());
  FinishedColor middle{};
  for (std::size_t axis = 0; axis < 4; ++axis) middle[axis] = static_cast<int>((2 * sum[axis] + count) / (2 * count));
  return middle;
}

}  // namespace

std::vector<FinishedColor> few_colors(const std::vector<FinishedColor>& colors, std::size_t max) {
  // Each colour once, in order, so that nothing depends on how vertices are numbered.
  std::vector<FinishedColor> different = colors;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  if (different.size() <= max) return colors;

  // Divides the longest box again and again, and boxes of several finishes in any case.
  std::vector<std::size_t> numbers(different.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto is_shorter = [](const ColorBox& a, const ColorBox& b) { return a.length < b.length; };
  std::vector<ColorBox> boxes{box_around(std::move(numbers), different)};
  while (true) {
    const auto longest = std::max_element(boxes.begin(), boxes.end(), is_shorter);
    if (longest->length == 0 || (boxes.size() >= max && longest->axis != finish_axis)) break;
    auto [lower, upper] = parted(*longest, different);
    *longest = std::move(lower);
    boxes.push_back(std::move(upper));
  }

  std::vector<FinishedColor> middle(different.size());
  for (const ColorBox& box : boxes)
    for (const std::size_t c : box.colors) middle[c] = middle_of(box, different);
  std::vector<FinishedColor> few;
  few.reserve(colors.size());
  for (const FinishedColor& color : colors) {
    const auto at = std::lower_bound(different.begin(), different.end(), color) - different.begin();
    few.push_back(middle[static_cast<std::size_t>(at)]);
  }
  return few;
}

}  // namespace pomona::pov
