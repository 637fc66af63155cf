#include "tests/cut/ray_volumes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pomona::rays {

namespace {

/// A place where a ray enters or leaves.
struct Pass {
  double height = 0;
  int into = 0;
};

double side(const Point& a, const Point& b, double x, double y) {
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/// The point in a frame whose third axis is the direction of rays: turned by angles that no knife has.
Point seen(const Point& p) {
  const double c1 = 0.8253356149096783, s1 = 0.5646424733950354;  // 0.6 radians
  const double c2 = 0.6216099682706644, s2 = 0.7833269096274834;  // 0.9
  const Point q{c1 * p[0] - s1 * p[1], s1 * p[0] + c1 * p[1], p[2]};
  return {q[0], c2 * q[1] - s2 * q[2], s2 * q[1] + c2 * q[2]};
}

class Lattice {
 public:
  Lattice(const std::vector<Triangle>& triangles, int across) {
    low_ = high_ = seen(triangles.front()[0]);
    for (const Triangle& t : triangles) {
      for (const Point& corner : t) {
        const Point p = seen(corner);
        for (std::size_t k = 0; k < 3; ++k) low_[k] = std::min(low_[k], p[k]), high_[k] = std::max(high_[k], p[k]);
      }
    }
    step_ = std::max(high_[0] - low_[0], high_[1] - low_[1]) / across;
    columns_ = static_cast<int>((high_[0] - low_[0]) / step_) + 1;
    rows_ = static_cast<int>((high_[1] - low_[1]) / step_) + 1;
    passes_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const Triangle& t : triangles) add({seen(t[0]), seen(t[1]), seen(t[2])});
  }

  RayVolumes sums() {
    RayVolumes all;
    for (std::vector<Pass>& ray : passes_) {
      std::sort(ray.begin(), ray.end(), [](const Pass& a, const Pass& b) { return a.height < b.height; });
      int winding = 0;
      for (std::size_t i = 0; i + 1 < ray.size(); ++i) {
        winding += ray[i].into;
        const double length = (ray[i + 1].height - ray[i].height) * step_ * step_;
        if (winding > 0) all.filled += length;
        all.counted += winding * length;
      }
      if (!ray.empty() && winding + ray.back().into != 0) ++all.broken;
    }
    return all;
  }

 private:
  double x(int column) const { return low_[0] + (column + 0.5137) * step_; }
  double y(int row) const { return low_[1] + (row + 0.4871) * step_; }

  void add(const Triangle& t) {
    const double area = side(t[0], t[1], t[2][0], t[2][1]);
    if (area == 0) return;
    const auto [left, right] = std::minmax({t[0][0], t[1][0], t[2][0]});
    const auto [bottom, top] = std::minmax({t[0][1], t[1][1], t[2][1]});
    const int first = std::max(0, static_cast<int>((left - low_[0]) / step_) - 1),
              last = std::min(columns_ - 1, static_cast<int>((right - low_[0]) / step_) + 1);
    const int under = std::max(0, static_cast<int>((bottom - low_[1]) / step_) - 1),
              over = std::min(rows_ - 1, static_cast<int>((top - low_[1]) / step_) + 1);
    for (int row = under; row <= over; ++row) {
      for (int column = first; column <= last; ++column) {
        const double a = side(t[1], t[2], x(column), y(row)) / area, b = side(t[2], t[0], x(column), y(row)) / area,
                     c = 1 - a - b;
        if (a < 0 || b < 0 || c < 0) continue;
        const auto ray =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
        passes_[ray].push_back({a * t[0][2] + b * t[1][2] + c * t[2][2], area < 0 ? 1 : -1});
      }
    }
  }

  Point low_{}, high_{};
  double step_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<Pass>> passes_;
};

}  // namespace

RayVolumes ray_volumes(const std::vector<Triangle>& triangles, int across) {
  if (triangles.empty()) return {};
  return Lattice(triangles, across).sums();
}

}  // namespace pomona::rays
