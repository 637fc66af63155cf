#include "generator/surface/sweep/grid_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"

namespace pomona {

namespace {

/// A triangle's corners in the plane of (turn, along), with the wanted place at 0,0; nothing if it has no room there.
std::optional<std::array<glm::dvec2, 3>> unrolled(const SweptGrid& grid, const glm::uvec3& t, double along,
                                                  double turn) {
  std::array<glm::dvec2, 3> corner;
  double left = 1, right = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = t[static_cast<int>(k)];
    const double ahead = grid.turn[v].value_or(turn) - turn;
    corner[k] = {ahead - std::round(ahead), grid.along[v] - along};
    if (!grid.turn[v]) continue;
    left = std::min(left, corner[k].x);
    right = std::max(right, corner[k].x);
  }
  // A corner on the axis lies at every azimuth of the triangle.
  for (std::size_t k = 0; k < 3; ++k) {
    if (!grid.turn[t[static_cast<int>(k)]] && left <= right) corner[k].x = std::clamp(0.0, left, right);
  }
  // Corners across the seam on the far side, or across the end of a closed vertical curve.
  const auto [low, high] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  if (right - left > 0.5 || high - low > 0.5) return {};
  return corner;
}

}  // namespace

std::vector<glm::dvec3> summed_normals(const SweptGrid& grid) {
  std::vector<glm::dvec3> normals(grid.position.size(), glm::dvec3(0));
  for (const glm::uvec3& t : grid.triangle) {
    const glm::dvec3& a = grid.position[t.x];
    const glm::dvec3 normal = glm::cross(grid.position[t.y] - a, grid.position[t.z] - a);
    for (int k = 0; k < 3; ++k) normals[t[k]] += normal;
  }
  return normals;
}

std::vector<glm::dvec3> unit_normals(const SweptGrid& grid) {
  std::vector<glm::dvec3> normals = summed_normals(grid);
  for (glm::dvec3& normal : normals) {
    const double size = glm::length(normal);
    normal = size > 0 ? normal / size : glm::dvec3(0);
  }
  return normals;
}

glm::dvec3 unit_across(const glm::dvec3& wanted, const glm::dvec3& normal) {
  const glm::dvec3 across = wanted - glm::dot(wanted, normal) * normal;
  const double size = glm::length(across);
  if (size > 1e-9 * glm::length(wanted)) return across / size;
  const glm::dvec3 other = std::fabs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, other));
}

glm::dvec3 uphill(const SweptGrid& grid, const glm::uvec3& t) {
  const glm::dvec3 &a = grid.position[t.x], &b = grid.position[t.y], &c = grid.position[t.z];
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  return glm::cross(normal, c - b) * grid.along[t.x] + glm::cross(normal, a - c) * grid.along[t.y] +
         glm::cross(normal, b - a) * grid.along[t.z];
}

struct GridPlaces::Found {
  double min = -1e300;  ///< smallest share of a corner: negative outside the triangle
  glm::uvec3 triangle{0};
  glm::dvec3 share{0};
};

GridPlaces::GridPlaces(const SweptGrid& grid) : grid_(grid), normals_(unit_normals(grid)), over_(bins + 1) {
  const auto bin = [](double along) { return static_cast<std::size_t>(std::clamp(along, 0.0, 1.0) * bins); };
  for (std::size_t i = 0; i < grid.triangle.size(); ++i) {
    const glm::uvec3& t = grid.triangle[i];
    const auto [low, high] = std::minmax({grid.along[t.x], grid.along[t.y], grid.along[t.z]});
    for (std::size_t k = bin(low); k <= bin(high); ++k) over_[k].push_back(static_cast<std::uint32_t>(i));
  }
}

GridPlaces::Found GridPlaces::found_among(const std::vector<std::uint32_t>& triangles, double along,
                                          double turn) const {
  Found best;
  for (const std::uint32_t i : triangles) {
    const glm::uvec3& t = grid_.triangle[i];
    const auto corner = unrolled(grid_, t, along, turn);
    if (!corner) continue;
    const auto& [a, b, c] = *corner;
    const double area = cross(b - a, c - a);
    if (area == 0) continue;
    const glm::dvec3 shares = glm::dvec3(cross(b, c), cross(c, a), cross(a, b)) / area;
    const double min = std::min({shares.x, shares.y, shares.z});
    if (min > best.min) best = {min, t, shares};
  }
  return best;
}

GridPoint GridPlaces::at(double along, double azimuth) const {
  // The triangle that contains the place, or is nearest to it: the one with the largest minimum share.
  const double turn = turn_of(azimuth);
  const auto bin = static_cast<std::size_t>(std::clamp(along, 0.0, 1.0) * bins);
  Found found = found_among(over_[bin], along, turn);
  if (found.min < 0) {
    std::vector<std::uint32_t> all(grid_.triangle.size());
    std::iota(all.begin(), all.end(), 0u);
    found = found_among(all, along, turn);
  }

  glm::dvec3 share(std::max(found.share.x, 0.0), std::max(found.share.y, 0.0), std::max(found.share.z, 0.0));
  share /= std::max(share.x + share.y + share.z, 1e-300);
  GridPoint point;
  glm::dvec3 normal(0);
  for (int k = 0; k < 3; ++k) {
    point.position += share[k] * grid_.position[found.triangle[k]];
    normal += share[k] * normals_[found.triangle[k]];
  }
  const double size = glm::length(normal);
  if (size > 0) point.normal = normal / size;
  point.uphill = unit_across(uphill(grid_, found.triangle), point.normal);
  return point;
}

GridPoint point_at(const SweptGrid& grid, double along, double azimuth) { return GridPlaces(grid).at(along, azimuth); }

}  // namespace pomona
