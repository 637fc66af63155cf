#include "render/truth/run_lengths.h"

namespace pomona {

std::vector<std::uint32_t> run_lengths(const Mask& mask, int width, int height) {
  // The positions along all columns, one after the other, at which covered runs begin and end.
  std::vector<std::uint32_t> runs;
  std::uint32_t last = 0;
  bool covered = false;
  const auto change_at = [&](std::uint32_t place) {
    runs.push_back(place - last);
    last = place;
    covered = !covered;
  };
  for (int x = mask.box.left; x <= mask.box.right; ++x) {
    const auto column = static_cast<std::uint32_t>(x) * static_cast<std::uint32_t>(height);
    if (covered && mask.box.top > 0) change_at(column);
    for (int y = mask.box.top; y <= mask.box.bottom; ++y) {
      if (mask.at(x, y) != covered) change_at(column + static_cast<std::uint32_t>(y));
    }
    if (covered && mask.box.bottom + 1 < height) change_at(column + static_cast<std::uint32_t>(mask.box.bottom) + 1);
  }

  // A run that reaches the bottom of the box's last column ends there.
  const std::uint32_t all = static_cast<std::uint32_t>(width) * static_cast<std::uint32_t>(height);
  const std::uint32_t behind = static_cast<std::uint32_t>(mask.box.right + 1) * static_cast<std::uint32_t>(height);
  if (covered && behind < all) change_at(behind);
  runs.push_back(all - last);
  return runs;
}

std::string packed(const std::vector<std::uint32_t>& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::int64_t rest = runs[i];
    if (i > 2) rest -= runs[i - 2];
    for (bool more = true; more;) {
      auto bits = static_cast<int>(rest & 0x1f);
      rest >>= 5;
      more = (bits & 0x10) != 0 ? rest != -1 : rest != 0;
      if (more) bits |= 0x20;
      text.push_back(static_cast<char>(bits + 48));
    }
  }
  return text;
}

}  // namespace pomona
