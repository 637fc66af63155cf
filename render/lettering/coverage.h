// Rasteriser of filled outlines: the covered share of each pixel.
#pragma once

#include <vector>

#include "render/lettering/typeface.h"

namespace pomona {

/// A straight line with square ends, `width` across. Empty for a point.
Outline line_outline(const glm::dvec2& a, const glm::dvec2& b, double width);

/// Sixteen corners are round enough for a dot.
Outline disc_outline(const glm::dvec2& center, double radius);

/// One value a pixel, 0..1; the same bits on every machine.
class Coverage {
 public:
  Coverage(int width, int height);

  /// Adds what the outline turns around: exact along each of 16 rows a pixel. What several outlines cover is covered
  /// once at most.
  void fill(const Outline& outline);

  double at(int x, int y) const { return values_[static_cast<std::size_t>(y) * width_ + x]; }

 private:
  void add_span(int y, double x0, double x1, double share);

  int width_, height_;
  std::vector<float> values_;
};

}  // namespace pomona
