#include "render/lettering/coverage.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr int rows_a_pixel = 16;

/// A crossing of a row with the outline, and whether the outline runs up or down.
struct OutlineCrossing {
  double x = 0;
  int turn = 0;
};

std::vector<OutlineCrossing> crossings(const Outline& outline, double y) {
  std::vector<OutlineCrossing> found;
  for (const auto& line : outline) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const glm::dvec2& a = line[i];
      const glm::dvec2& b = line[i + 1 < line.size() ? i + 1 : 0];
      if ((a.y <= y) == (b.y <= y)) continue;
      found.push_back({a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), a.y <= y ? 1 : -1});
    }
  }
  std::sort(found.begin(), found.end(), [](const OutlineCrossing& p, const OutlineCrossing& q) {
    return p.x < q.x || (p.x == q.x && p.turn < q.turn);
  });
  return found;
}

}  // namespace

Outline line_outline(const glm::dvec2& a, const glm::dvec2& b, double width) {
  const double length = std::sqrt(glm::dot(b - a, b - a));
  if (length <= 0) return {};
  const glm::dvec2 across = glm::dvec2(-(b - a).y, (b - a).x) * (0.5 * width / length);
  return {{a + across, b + across, b - across, a - across}};
}

Outline disc_outline(const glm::dvec2& center, double radius) {
  constexpr double half = 0.7071067811865476, far = 0.9238795325112867, near = 0.3826834323650898;
  const glm::dvec2 eighth[4] = {{1, 0}, {far, near}, {half, half}, {near, far}};
  std::vector<glm::dvec2> circle;
  glm::dvec2 right(1, 0), down(0, 1);
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const glm::dvec2& p : eighth) circle.push_back(center + (right * p.x + down * p.y) * radius);
    right = glm::dvec2(-right.y, right.x);
    down = glm::dvec2(-down.y, down.x);
  }
  return {circle};
}

Coverage::Coverage(int width, int height)
    : width_(width), height_(height), values_(static_cast<std::size_t>(width) * height, 0.0f) {}

void Coverage::fill(const Outline& outline) {
  double low = height_, high = 0;
  for (const auto& line : outline) {
    for (const glm::dvec2& p : line) low = std::min(low, p.y), high = std::max(high, p.y);
  }
  const int first = static_cast<int>(std::floor(std::clamp(low, 0.0, static_cast<double>(height_))));
  const int last = static_cast<int>(std::ceil(std::clamp(high, 0.0, static_cast<double>(height_))));
  for (int y = first; y < last; ++y) {
    for (int row = 0; row < rows_a_pixel; ++row) {
      const std::vector<OutlineCrossing> found = crossings(outline, y + (row + 0.5) / rows_a_pixel);
      int winding = 0;
      for (std::size_t i = 0; i + 1 < found.size(); ++i) {
        winding += found[i].turn;
        if (winding != 0) add_span(y, found[i].x, found[i + 1].x, 1.0 / rows_a_pixel);
      }
    }
  }
}

void Coverage::add_span(int y, double x0, double x1, double share) {
  x0 = std::clamp(x0, 0.0, static_cast<double>(width_));
  x1 = std::clamp(x1, 0.0, static_cast<double>(width_));
  float* row = values_.data() + static_cast<std::size_t>(y) * width_;
  for (int x = static_cast<int>(x0); x < width_ && x < x1; ++x) {
    const double covered = std::min(x1, x + 1.0) - std::max(x0, static_cast<double>(x));
    row[x] = std::min(1.0f, row[x] + static_cast<float>(covered * share));
  }
}

}  // namespace pomona
