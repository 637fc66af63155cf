#include "tests/shapes/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

using Corners = std::array<glm::dvec3, 3>;

double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return glm::dot(b - a, glm::cross(c - a, d - a));
}

bool pierces(const glm::dvec3& p, const glm::dvec3& q, const Corners& t) {
  if (volume(t[0], t[1], t[2], p) * volume(t[0], t[1], t[2], q) >= 0) return false;
  const double a = volume(p, q, t[0], t[1]), b = volume(p, q, t[1], t[2]), c = volume(p, q, t[2], t[0]);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

bool cross(const Corners& s, const Corners& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (pierces(s[i], s[(i + 1) % 3], t) || pierces(t[i], t[(i + 1) % 3], s)) return true;
  }
  return false;
}

struct Box {
  glm::dvec3 low, high;
  std::size_t triangle = 0;
};

bool overlap(const Box& a, const Box& b) {
  return a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

}  // namespace

std::map<std::pair<int, int>, int> crossing_triangles(const DiffusionSurfaces& surfaces) {
  std::vector<Corners> corners;
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    const glm::uvec3& v = surfaces.triangle[t];
    corners.push_back({surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]});
    const Corners& c = corners.back();
    boxes.push_back({glm::min(c[0], glm::min(c[1], c[2])), glm::max(c[0], glm::max(c[1], c[2])), t});
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.low.x < b.low.x; });
  std::map<std::pair<int, int>, int> count;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low.x <= boxes[i].high.x; ++j) {
      const std::size_t s = boxes[i].triangle, t = boxes[j].triangle;
      const auto pair = std::minmax(surfaces.surface[s], surfaces.surface[t]);
      if (pair.first == pair.second || !overlap(boxes[i], boxes[j])) continue;
      if (cross(corners[s], corners[t])) ++count[pair];
    }
  }
  return count;
}

}  // namespace pomona
