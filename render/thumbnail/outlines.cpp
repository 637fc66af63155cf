#include "render/thumbnail/outlines.h"

#include <cmath>

namespace pomona {

namespace {

/// A round nib: the offsets of the samples that it covers.
std::vector<std::pair<int, int>> nib(double width) {
  std::vector<std::pair<int, int>> offsets;
  const double radius = 0.5 * width;
  const int reach = static_cast<int>(std::ceil(radius));
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      if (x * x + y * y <= radius * radius) offsets.emplace_back(x, y);
  return offsets;
}

}  // namespace

std::vector<std::uint32_t> outlines(const SampleGrid& grid, const OutlineWidths& widths) {
  const int side = grid.side();
  std::vector<std::uint32_t> ink(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
  const auto outer = nib(widths.outer), rim = nib(widths.rim);
  const auto draw = [&](int x, int y, std::uint32_t a, std::uint32_t b) {
    // The nearer of the two has the line.
    const bool same_piece = a != 0 && b != 0 && instance_of(a) == instance_of(b);
    for (const auto& [dx, dy] : same_piece ? rim : outer) {
      const int to_x = x + dx, to_y = y + dy;
      if (to_x < 0 || to_y < 0 || to_x >= side || to_y >= side) continue;
      ink[grid.index(to_x, to_y)] = a != 0 ? a : b;
    }
  };

  // Wherever two neighbours belong to different things.
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const std::uint32_t here = grid.owner(x, y), right = grid.owner(x + 1, y), below = grid.owner(x, y + 1);
      if (here != right) draw(x, y, here, right);
      if (here != below) draw(x, y, here, below);
    }
  }
  return ink;
}

}  // namespace pomona
