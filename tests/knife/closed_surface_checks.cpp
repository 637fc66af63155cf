#include "tests/knife/closed_surface_checks.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace pomona {

double volume_of(const ClosedSurface& surface) {
  double volume = 0;
  for (const glm::uvec3& t : surface.triangle) {
    volume += glm::dot(surface.point[t.x], glm::cross(surface.point[t.y], surface.point[t.z])) / 6;
  }
  return volume;
}

namespace {

double twice_area(const ClosedSurface& surface, const glm::uvec3& t) {
  const glm::dvec3 a = surface.point[t.x];
  return glm::length(glm::cross(surface.point[t.y] - a, surface.point[t.z] - a));
}

}  // namespace

double area_of(const ClosedSurface& surface) {
  double area = 0;
  for (const glm::uvec3& t : surface.triangle) area += 0.5 * twice_area(surface, t);
  return area;
}

bool is_closed(const ClosedSurface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::vector<bool> used(surface.point.size(), false);
  for (const glm::uvec3& t : surface.triangle) {
    for (int i = 0; i < 3; ++i) {
      ++edges[{t[i], t[(i + 1) % 3]}];
      used[t[i]] = true;
    }
  }
  const bool paired = std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
    const auto& [edge, count] = entry;
    return count == 1 && edges.contains({edge.second, edge.first});
  });
  return paired && !surface.triangle.empty() && std::find(used.begin(), used.end(), false) == used.end();
}

double thinnest_of(const ClosedSurface& surface) {
  double thinnest = 1;
  for (const glm::uvec3& t : surface.triangle) {
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      longest = std::max(longest, glm::distance(surface.point[t[i]], surface.point[t[(i + 1) % 3]]));
    }
    thinnest = std::min(thinnest, twice_area(surface, t) / (longest * longest));
  }
  return thinnest;
}

}  // namespace pomona
