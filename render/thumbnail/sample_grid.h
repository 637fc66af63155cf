// Triangles to samples: a z-buffer with a colour and an owner for each sample.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/base/color.h"
#include "render/thumbnail/projection.h"

namespace pomona {

struct GridCorner {
  ProjectedPoint at;
  Color color{0};
};

class SampleGrid {
 public:
  explicit SampleGrid(int side);

  /// Draws a triangle wherever it is nearer than earlier ones; of equally near triangles the first stays. Corners are
  /// rounded to a grid of 1/16 sample, so that neighbours leave no gap.
  /// \param owner above 0.
  void draw(const std::array<GridCorner, 3>& corners, std::uint32_t owner);

  int side() const { return side_; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * side_ + x; }
  std::uint32_t owner(int x, int y) const { return owner_[index(x, y)]; }  ///< 0: nothing was drawn there
  double nearness(int x, int y) const { return static_cast<double>(nearness_[index(x, y)]); }
  const Color& color(int x, int y) const { return color_[index(x, y)]; }

 private:
  int side_;
  std::vector<float> nearness_;
  std::vector<std::uint32_t> owner_;
  std::vector<Color> color_;
};

}  // namespace pomona
