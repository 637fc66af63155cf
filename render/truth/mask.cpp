#include "render/truth/mask.h"

#include <algorithm>

namespace pomona {

namespace {

/// The smallest box around pixels.
class Around {
 public:
  void add(int x, int y) {
    box_.left = empty_ ? x : std::min(box_.left, x);
    box_.right = empty_ ? x : std::max(box_.right, x);
    box_.top = empty_ ? y : std::min(box_.top, y);
    box_.bottom = empty_ ? y : std::max(box_.bottom, y);
    empty_ = false;
  }
  const PixelBox& box() const { return box_; }

 private:
  PixelBox box_;
  bool empty_ = true;
};

Mask blank(const PixelBox& box) {
  return {box, std::vector<std::uint8_t>(static_cast<std::size_t>(box.width()) * box.height(), 0)};
}

}  // namespace

std::size_t Mask::area() const {
  return static_cast<std::size_t>(std::count(covered.begin(), covered.end(), std::uint8_t{1}));
}

Mask trimmed(const Mask& mask) {
  Around around;
  for (int y = mask.box.top; y <= mask.box.bottom; ++y) {
    for (int x = mask.box.left; x <= mask.box.right; ++x) {
      if (mask.at(x, y)) around.add(x, y);
    }
  }
  Mask small = blank(around.box());
  std::size_t i = 0;
  for (int y = small.box.top; y <= small.box.bottom; ++y) {
    for (int x = small.box.left; x <= small.box.right; ++x) small.covered[i++] = mask.at(x, y) ? 1 : 0;
  }
  return small;
}

std::vector<Mask> visible_masks(const std::vector<std::uint16_t>& numbers, int width, std::size_t count) {
  // First finds the sizes, then the pixels.
  std::vector<Around> around(count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    around[numbers[i] - 1u].add(static_cast<int>(i % width), static_cast<int>(i / width));
  }
  std::vector<Mask> masks;
  for (const Around& one : around) masks.push_back(blank(one.box()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    Mask& mask = masks[numbers[i] - 1u];
    const int x = static_cast<int>(i % width) - mask.box.left, y = static_cast<int>(i / width) - mask.box.top;
    mask.covered[static_cast<std::size_t>(y) * mask.box.width() + x] = 1;
  }
  return masks;
}

}  // namespace pomona
