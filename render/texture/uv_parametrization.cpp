#include "render/texture/uv_parametrization.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/mesh/box.h"

namespace pomona {

namespace {

constexpr int max_sweeps = 120;
constexpr double over_relaxation = 1.7;
constexpr double at_rest = 2e-4;   // as a share of the patch's size: iteration ends when the longest step is below
constexpr double min_area = 0.05;  // smallest area of a flattened triangle, as a share of its own

/// A flattened triangle: its first corner at the origin, its second on the x axis.
std::array<glm::dvec2, 3> at_rest_shape(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a;
  const double along = std::sqrt(glm::dot(ab, ab));
  if (!(along > 0)) return {};
  const glm::dvec3 n = glm::cross(ab, ac);
  return {glm::dvec2(0), glm::dvec2(along, 0), glm::dvec2(glm::dot(ac, ab) / along, std::sqrt(glm::dot(n, n)) / along)};
}

/// Moves points towards the positions that their triangles, each in its rotation, give them.
class Relaxation {
 public:
  Relaxation(const Patch3& patch, std::vector<glm::dvec2> start) : patch_(patch), flat_(std::move(start)) {
    rest_.reserve(patch.triangle.size());
    for (const glm::uvec3& t : patch.triangle) {
      rest_.push_back(at_rest_shape(patch.point[t.x], patch.point[t.y], patch.point[t.z]));
      const auto& r = rest_.back();
      area_.push_back(cross(r[1] - r[0], r[2] - r[0]));
      weights_.push_back(cotangents(r));
    }
    turn_.assign(patch.triangle.size(), glm::dvec2(1, 0));
    first_.assign(patch.point.size() + 1, 0);
    for (const glm::uvec3& t : patch.triangle) {
      for (int k = 0; k < 3; ++k) ++first_[t[k] + 1];
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    around_.resize(3 * patch.triangle.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < patch.triangle.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) around_[next[patch.triangle[t][k]]++] = {t, k};
    }
  }

  std::vector<glm::dvec2> run() {
    double size = 0;
    for (const glm::dvec2& p : flat_) size = std::max({size, std::abs(p.x - flat_[0].x), std::abs(p.y - flat_[0].y)});
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
      for (std::size_t t = 0; t < turn_.size(); ++t) turn_[t] = turn_of(t);
      double longest = 0;
      for (std::uint32_t p = 0; p < flat_.size(); ++p) longest = std::max(longest, move(p));
      if (longest < at_rest * size) break;
    }
    return std::move(flat_);
  }

 private:
  struct Corner {
    std::uint32_t triangle = 0, corner = 0;
  };

  /// Cotangents of the angles at the corners, limited for slivers.
  static std::array<double, 3> cotangents(const std::array<glm::dvec2, 3>& r) {
    std::array<double, 3> w{1, 1, 1};
    const double area = cross(r[1] - r[0], r[2] - r[0]);
    for (std::size_t k = 0; k < 3 && area > 0; ++k) {
      const glm::dvec2 e = r[(k + 1) % 3] - r[k], f = r[(k + 2) % 3] - r[k];
      w[k] = std::clamp(glm::dot(e, f) / area, 0.05, 20.0);
    }
    return w;
  }

  /// The rotation (cosine, sine) that fits the triangle's position best.
  glm::dvec2 turn_of(std::size_t t) const {
    const glm::uvec3& v = patch_.triangle[t];
    double cosine = 0, sine = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const glm::dvec2 r = rest_[t][j] - rest_[t][i];
      const glm::dvec2 f = flat_[v[static_cast<int>(j)]] - flat_[v[static_cast<int>(i)]];
      cosine += weights_[t][k] * glm::dot(r, f);
      sine += weights_[t][k] * cross(r, f);
    }
    const double length = std::sqrt(cosine * cosine + sine * sine);
    return length > 0 ? glm::dvec2(cosine, sine) / length : glm::dvec2(1, 0);
  }

  /// Moves one point as far as no triangle around it turns over or gets too flat; returns the distance.
  double move(std::uint32_t p) {
    // The mean position that the triangles around give the point.
    glm::dvec2 sum(0);
    double weight = 0;
    for (std::size_t i = first_[p]; i < first_[p + 1]; ++i) {
      const auto [t, k] = around_[i];
      for (const std::uint32_t other : {(k + 1) % 3, (k + 2) % 3}) {
        const double w = weights_[t][3 - k - other];
        const glm::dvec2 r = rest_[t][k] - rest_[t][other];
        const glm::dvec2 turned(turn_[t].x * r.x - turn_[t].y * r.y, turn_[t].y * r.x + turn_[t].x * r.y);
        sum += w * (flat_[patch_.triangle[t][static_cast<int>(other)]] + turned);
        weight += w;
      }
    }
    if (!(weight > 0)) return 0;

    // Moves there and beyond; a half, a quarter or an eighth of that if a triangle forbids more, or not at all.
    const glm::dvec2 from = flat_[p];
    glm::dvec2 step = over_relaxation * (sum / weight - from);
    for (int halving = 0; halving < 4; ++halving, step *= 0.5) {
      flat_[p] = from + step;
      if (stays_open(p)) return std::max(std::abs(step.x), std::abs(step.y));
    }
    flat_[p] = from;
    return 0;
  }

  bool stays_open(std::uint32_t p) const {
    for (std::size_t i = first_[p]; i < first_[p + 1]; ++i) {
      const std::uint32_t t = around_[i].triangle;
      const glm::uvec3& v = patch_.triangle[t];
      if (area_[t] > 0 && cross(flat_[v.y] - flat_[v.x], flat_[v.z] - flat_[v.x]) < min_area * area_[t]) return false;
    }
    return true;
  }

  const Patch3& patch_;
  std::vector<glm::dvec2> flat_;
  std::vector<std::array<glm::dvec2, 3>> rest_;
  std::vector<double> area_;  // twice the triangle's own
  std::vector<std::array<double, 3>> weights_;
  std::vector<glm::dvec2> turn_;
  std::vector<std::size_t> first_;  // per point, into around_
  std::vector<Corner> around_;
};

/// Whether a line along one of a's edges separates the two.
bool parts(const std::array<glm::dvec2, 3>& a, const std::array<glm::dvec2, 3>& b, double slack) {
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 edge = a[(k + 1) % 3] - a[k];
    const double length = std::sqrt(glm::dot(edge, edge));
    const auto outside = [&](const glm::dvec2& p) { return cross(edge, p - a[k]) <= slack * length; };
    if (std::all_of(b.begin(), b.end(), outside)) return true;
  }
  return false;
}

/// Triangles by the cells of a grid that their boxes touch.
class TriangleGrid {
 public:
  TriangleGrid(std::span<const glm::uvec3> triangles, std::span<const glm::dvec2> flat)
      : triangles_(triangles), flat_(flat), low_(flat.empty() ? glm::dvec2(0) : flat.front()), high_(low_) {
    for (const glm::dvec2& p : flat) low_ = glm::min(low_, p), high_ = glm::max(high_, p);
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(triangles.size()))), 1, 512);
    cells_.resize(static_cast<std::size_t>(side_) * side_);
  }

  std::array<glm::dvec2, 3> corners(std::uint32_t t) const {
    return {flat_[triangles_[t].x], flat_[triangles_[t].y], flat_[triangles_[t].z]};
  }

  template <typename Visit>
  void visit_cells(std::uint32_t t, const Visit& visit) {
    const auto c = corners(t);
    const glm::ivec2 from = cell(glm::min(c[0], glm::min(c[1], c[2])));
    const glm::ivec2 to = cell(glm::max(c[0], glm::max(c[1], c[2])));
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) visit(cells_[static_cast<std::size_t>(y) * side_ + x]);
    }
  }

 private:
  glm::ivec2 cell(const glm::dvec2& p) const {
    const glm::dvec2 extent = high_ - low_;
    glm::ivec2 at(0);
    for (int k = 0; k < 2; ++k) {
      if (extent[k] > 0) at[k] = std::clamp(static_cast<int>((p[k] - low_[k]) / extent[k] * side_), 0, side_ - 1);
    }
    return at;
  }

  std::span<const glm::uvec3> triangles_;
  std::span<const glm::dvec2> flat_;
  glm::dvec2 low_, high_;
  int side_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

bool share_a_corner(const glm::uvec3& a, const glm::uvec3& b) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[i] == b[j]) return true;
    }
  }
  return false;
}

double longest_edge(const std::array<glm::dvec2, 3>& corners) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, glm::distance(corners[k], corners[(k + 1) % 3]));
  return longest;
}

}  // namespace

Stretch stretch_of(const Patch3& patch, std::span<const glm::dvec2> flat) {
  Box<double> box;
  for (const glm::dvec3& p : patch.point) box.add(p);
  const double narrowest = 1e-4 * glm::length(box.size());
  double sum = 0, area = 0, worst = 1;
  for (const glm::uvec3& t : patch.triangle) {
    const auto r = at_rest_shape(patch.point[t.x], patch.point[t.y], patch.point[t.z]);
    const double own = cross(r[1] - r[0], r[2] - r[0]);
    if (!(own > narrowest * longest_edge(r))) continue;
    // The two columns of the map: images of unit steps along x and y of the triangle's own plane.
    const glm::dvec2 e = flat[t.y] - flat[t.x], f = flat[t.z] - flat[t.x];
    const glm::dvec2 x = e / r[1].x, y = (f - x * r[2].x) / r[2].y;
    const double a = glm::dot(x, x), b = glm::dot(x, y), c = glm::dot(y, y);
    const double root = std::sqrt((a - c) * (a - c) + 4 * b * b);
    const double max = std::sqrt(std::max(0.0, 0.5 * (a + c + root)));
    const double min = std::sqrt(std::max(1e-12, 0.5 * (a + c - root)));
    const double either = std::max(max, 1 / min);
    sum += own * either;
    area += own;
    worst = std::max(worst, either);
  }
  return {area > 0 ? sum / area : 1.0, worst, 0.5 * area};
}

std::vector<glm::dvec2> relaxed(const Patch3& patch, std::vector<glm::dvec2> projected) {
  if (projected.empty()) return projected;
  return Relaxation(patch, std::move(projected)).run();
}

std::vector<std::uint32_t> overlapping(std::span<const glm::uvec3> triangles, std::span<const glm::dvec2> flat) {
  // The size of the patch; the slack is a share of it.
  TriangleGrid grid(triangles, flat);
  double size = 0;
  for (const glm::dvec2& p : flat) size = std::max({size, std::abs(p.x - flat[0].x), std::abs(p.y - flat[0].y)});
  std::vector<std::uint32_t> found;

  // Compares each triangle with those accepted before; it is accepted if it overlaps none.
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto own = grid.corners(t);
    if (!(cross(own[1] - own[0], own[2] - own[0]) > 0)) continue;
    bool covers = false;
    grid.visit_cells(t, [&](const std::vector<std::uint32_t>& cell) {
      for (const std::uint32_t other : cell) {
        if (covers || share_a_corner(triangles[t], triangles[other])) continue;
        const auto theirs = grid.corners(other);
        covers = !parts(own, theirs, 1e-9 * size) && !parts(theirs, own, 1e-9 * size);
      }
    });
    if (covers) {
      found.push_back(t);
    } else {
      grid.visit_cells(t, [&](std::vector<std::uint32_t>& cell) { cell.push_back(t); });
    }
  }
  return found;
}

}  // namespace pomona
