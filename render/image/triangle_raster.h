// The rasteriser of the processor: the samples of a picture that a triangle covers, with their barycentric coordinates
// [Pineda 1988]. With integers (fixed point) the results are exact; with `double` they are right up to rounding at the
// edges.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pomona {

/// Columns and rows of a picture, both ends included.
struct PixelBox {
  int left = 0, top = 0, right = -1, bottom = -1;

  bool empty() const { return right < left || bottom < top; }
  int width() const { return empty() ? 0 : right - left + 1; }
  int height() const { return empty() ? 0 : bottom - top + 1; }
};

/// The samples of a box: sample (x, y) lies at first + step * (x, y).
template <typename Number>
struct RasterSamples {
  Number first, step;
  PixelBox box;
};

/// Whether a triangle covers samples that lie exactly on its edges.
enum class EdgeRule {
  closed,   ///< all samples on edges: two triangles that share an edge both cover them
  top_left  ///< samples on top and left edges (y down): exactly one of two triangles covers a shared edge
};

template <typename Number>
class TriangleRaster {
 public:
  using Point = glm::vec<2, Number>;
  using Shares = glm::vec<3, Number>;

  /// Either orientation is allowed. Fixed-point corners must be below 2^30.
  TriangleRaster(const Point& a, const Point& b, const Point& c)
      : corner_{a, b, c}, turn_(side(a, b, c) < 0 ? -1 : 1), area_(turn_ * side(a, b, c)) {}

  /// Twice the area, never negative.
  Number area() const { return area_; }

  /// How the corners follow each other as seen (y down); true where there is no area.
  bool is_clockwise() const { return turn_ > 0; }

  /// Each corner's share of the sample, times area(); nothing if the triangle does not cover the sample.
  std::optional<Shares> shares(const Point& sample, EdgeRule rule = EdgeRule::closed) const {
    Shares all(0);
    for (int i = 0; i < 3; ++i) {
      all[i] = turn_ * side(start(i), end(i), sample);
      if (all[i] < 0 || (all[i] == 0 && rule == EdgeRule::top_left && !is_top_or_left(i))) return std::nullopt;
    }
    if (area_ == 0) return std::nullopt;
    return all;
  }

  /// True if one edge has the whole square on its outer side, so that the triangle does not cover it. A quick test: it
  /// may be false for squares beside a corner.
  bool misses(const Point& middle, Number half_width) const {
    for (int i = 0; i < 3; ++i) {
      const Point along = glm::abs(end(i) - start(i));
      if (turn_ * side(start(i), end(i), middle) + (along.x + along.y) * half_width < 0) return true;
    }
    return false;
  }

  /// The samples in the triangle's bounding box.
  PixelBox box(const RasterSamples<Number>& samples) const {
    const Point low = glm::min(glm::min(corner_[0], corner_[1]), corner_[2]),
                high = glm::max(glm::max(corner_[0], corner_[1]), corner_[2]);
    const auto first = [&](Number at, int min, int max) {
      return static_cast<int>(std::clamp<Number>(-whole(samples.first - at, samples.step), min, max + Number(1)));
    };
    const auto last = [&](Number at, int min, int max) {
      return static_cast<int>(std::clamp<Number>(whole(at - samples.first, samples.step), min - Number(1), max));
    };
    const PixelBox& b = samples.box;
    return {first(low.x, b.left, b.right), first(low.y, b.top, b.bottom), last(high.x, b.left, b.right),
            last(high.y, b.top, b.bottom)};
  }

  /// Calls visit(x, y, shares) for each covered sample, row by row.
  template <typename Visit>
  void for_covered(const RasterSamples<Number>& samples, const Visit& visit, EdgeRule rule = EdgeRule::closed) const {
    const PixelBox b = box(samples);
    for (int y = b.top; y <= b.bottom; ++y) {
      for (int x = b.left; x <= b.right; ++x) {
        const Point sample(samples.first + samples.step * x, samples.first + samples.step * y);
        if (const std::optional<Shares> all = shares(sample, rule)) visit(x, y, *all);
      }
    }
  }

 private:
  /// Above 0 to the right of the way from a to b (y down), 0 on it.
  static Number side(const Point& a, const Point& b, const Point& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  static Number whole(Number value, Number step) {
    if constexpr (std::is_floating_point_v<Number>)
      return std::floor(value / step);
    else
      return value / step - (value % step < 0 ? 1 : 0);
  }

  /// The edge across from corner `i`.
  const Point& start(int i) const { return corner_[static_cast<std::size_t>(i + 1) % 3]; }
  const Point& end(int i) const { return corner_[static_cast<std::size_t>(i + 2) % 3]; }
  bool is_top_or_left(int i) const {
    const Point along = (end(i) - start(i)) * turn_;
    return along.y == 0 ? along.x > 0 : along.y < 0;
  }

  std::array<Point, 3> corner_;
  Number turn_;  // 1 or -1: side() times this is not negative within
  Number area_;
};

}  // namespace pomona
