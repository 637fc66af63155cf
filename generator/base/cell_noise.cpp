#include "generator/base/cell_noise.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/gradient_noise.h"

namespace pomona {

namespace {

/// The place of a unit cell's feature point in it.
glm::dvec3 feature_point(std::uint32_t hash) {
  const glm::dvec3 share(hash & 1023u, (hash >> 10) & 1023u, (hash >> 20) & 1023u);
  return share * (0.9 / 1023.0) + 0.05;
}

}  // namespace

CellPlace cell_place(const glm::dvec3& point, std::uint32_t seed) {
  const glm::dvec3 low(std::floor(point.x), std::floor(point.y), std::floor(point.z));
  const glm::dvec3 within = point - low;
  CellPlace place{.nearest = 8, .second = 8};  // squared, until the end
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const std::uint32_t hash =
            lattice_hash(lattice_cell(low.x) + x, lattice_cell(low.y) + y, lattice_cell(low.z) + z, seed);
        const glm::dvec3 away = glm::dvec3(x, y, z) + feature_point(hash) - within;
        const double squared = glm::dot(away, away);
        if (squared < place.nearest) {
          place = {squared, place.nearest, hash};
        } else {
          place.second = std::min(place.second, squared);
        }
      }
    }
  }
  place.nearest = std::sqrt(place.nearest);
  place.second = std::sqrt(place.second);
  return place;
}

}  // namespace pomona
