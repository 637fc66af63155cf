#include "render/texture/chart_outline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/mesh/edges.h"

namespace pomona {

namespace {

/// The convex hull, counter-clockwise where y runs up [Andrew 1979].
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<glm::dvec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const glm::dvec2& p : points) {
      while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  if (hull.empty()) hull.push_back(points.front());
  return hull;
}

struct OutlineExtent {
  glm::dvec2 low, high;
};

OutlineExtent extent_of(std::span<const glm::dvec2> hull, const Turn& turn) {
  OutlineExtent extent{turned(turn, hull.front()), turned(turn, hull.front())};
  for (const glm::dvec2& p : hull) {
    const glm::dvec2 q = turned(turn, p);
    extent.low = glm::min(extent.low, q), extent.high = glm::max(extent.high, q);
  }
  return extent;
}

/// One side of the smallest box around a hull lies along one of its edges.
Turn smallest_box(std::span<const glm::dvec2> hull) {
  Turn best(1, 0);
  double min = -1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    const double length = std::sqrt(glm::dot(edge, edge));
    if (!(length > 0)) continue;
    const Turn turn(edge.x / length, -edge.y / length);
    const OutlineExtent extent = extent_of(hull, turn);
    const double area = (extent.high.x - extent.low.x) * (extent.high.y - extent.low.y);
    if (min >= 0 && area >= min * (1 - 1e-9)) continue;
    min = area;
    best = turn;
  }
  return best;
}

/// Marks every cell within `slack` of a line, which lies within the mask.
void mark_line(BlockMask& mask, const glm::dvec2& p, const glm::dvec2& q) {
  constexpr double slack = 1e-3;
  const glm::dvec2 &upper = p.y <= q.y ? p : q, &lower = p.y <= q.y ? q : p;
  const int first = std::max(0, static_cast<int>(std::floor(upper.y - slack)));
  const int last = std::min(mask.height - 1, static_cast<int>(std::floor(lower.y + slack)));
  for (int y = first; y <= last; ++y) {
    // The part of the line in this row of cells.
    double from = 0, to = 1;
    const double rise = lower.y - upper.y;
    if (rise > slack) {
      from = std::clamp((y - slack - upper.y) / rise, 0.0, 1.0);
      to = std::clamp((y + 1 + slack - upper.y) / rise, 0.0, 1.0);
    }
    const double begin = upper.x + from * (lower.x - upper.x), end = upper.x + to * (lower.x - upper.x);
    const int left = std::max(0, static_cast<int>(std::floor(std::min(begin, end) - slack)));
    const int right = std::min(mask.width - 1, static_cast<int>(std::floor(std::max(begin, end) + slack)));
    for (int x = left; x <= right; ++x) mask.set(x, y);
  }
}

/// Marks the cells whose middles lie within closed lines.
void mark_within(BlockMask& mask, std::span<const std::array<glm::dvec2, 2>> lines) {
  std::vector<std::pair<int, double>> crossings;  // row, place in it
  for (const auto& [p, q] : lines) {
    const glm::dvec2 &upper = p.y <= q.y ? p : q, &lower = p.y <= q.y ? q : p;
    const int first = std::max(0, static_cast<int>(std::ceil(upper.y - 0.5)));
    for (int y = first; y < mask.height && y + 0.5 < lower.y; ++y) {
      const double share = (y + 0.5 - upper.y) / (lower.y - upper.y);
      crossings.emplace_back(y, upper.x + share * (lower.x - upper.x));
    }
  }
  // Two by two in each row; rounding may leave one alone.
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size();) {
    const auto& [y, begin] = crossings[i];
    const auto& [y_of_end, end] = crossings[i + 1];
    if (y_of_end != y) {
      ++i;
      continue;
    }
    const int left = std::max(0, static_cast<int>(std::ceil(begin - 0.5)));
    for (int x = left; x < mask.width && x + 0.5 < end; ++x) mask.set(x, y);
    i += 2;
  }
}

}  // namespace

BlockMask speck_mask() {
  BlockMask mask(1, 1);
  mask.set(0, 0);
  mask.count = 1;
  return mask;
}

Chart turned(const Chart& chart, const Turn& turn) {
  Chart result = chart;
  glm::dvec2 low(0), high(0);
  for (std::size_t i = 0; i < chart.flat.size(); ++i) {
    const glm::dvec2 p = turned(turn, chart.flat[i]);
    low = i == 0 ? p : glm::min(low, p), high = i == 0 ? p : glm::max(high, p);
    result.flat[i] = p;
  }
  for (glm::dvec2& p : result.flat) p -= low;
  result.size = high - low;
  return result;
}

ChartOutline::ChartOutline(const Chart& chart) {
  for_each_edge(sorted_half_edges(chart.corners), [&](std::span<const HalfEdge> edge) {
    if (edge.size() % 2 == 0) return;
    edges_.push_back({chart.flat[edge.front().low], chart.flat[edge.front().high]});
  });
  for (const glm::uvec3& t : chart.corners)
    area_ += 0.5 * std::abs(cross(chart.flat[t.y] - chart.flat[t.x], chart.flat[t.z] - chart.flat[t.x]));
  hull_ = hull_of(chart.flat);

  turns_ = {{1, 0}};
  if (chart.frame) return;
  constexpr double eighth = 0.70710678118654752440;
  const Turn first = smallest_box(hull_), second = eighth * Turn(first.x - first.y, first.x + first.y);
  turns_ = {first, second, {-first.y, first.x}, {-second.y, second.x}};
  for (std::size_t i = 0; i < 4; ++i) turns_.push_back(-turns_[i]);
}

BlockMask ChartOutline::mask(const Turn& turn, double blocks_per_metre) const {
  // The blocks in which a look-up may lie: those that the chart touches.
  constexpr double slack = 1e-3;
  const auto [low, high] = extent_of(hull_, turn);
  const glm::ivec2 cells(glm::floor((high - low) * blocks_per_metre + slack) + 1.0);
  BlockMask touched(cells.x, cells.y);
  std::vector<std::array<glm::dvec2, 2>> lines;
  for (const auto& [p, q] : edges_)
    lines.push_back({(turned(turn, p) - low) * blocks_per_metre, (turned(turn, q) - low) * blocks_per_metre});
  for (const auto& [p, q] : lines) mark_line(touched, p, q);
  mark_within(touched, lines);

  // From each of them a look-up also reads the blocks to the right and below.
  BlockMask mask(cells.x + 1, cells.y + 1);
  for (int y = 0; y < cells.y; ++y) {
    for (const int below : {y, y + 1}) {
      std::uint64_t* const row = &mask.bits[static_cast<std::size_t>(below) * mask.words()];
      std::uint64_t last = 0;
      for (int w = 0; w < mask.words(); ++w) {
        const std::uint64_t word =
            w < touched.words() ? touched.bits[static_cast<std::size_t>(y) * touched.words() + w] : 0;
        row[w] |= word | word << 1 | last >> 63;
        last = word;
      }
    }
  }
  for (const std::uint64_t word : mask.bits) mask.count += std::popcount(word);
  return mask;
}

}  // namespace pomona
