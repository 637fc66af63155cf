#include "generator/diffusion/harmonic/cell_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/cut_links.h"

namespace pomona {

namespace {

/// Ranges of layers that are worked on one by one.
constexpr int slab_count = 16;

/// Cell and triangle, in the order in which they were found.
using Entries = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void add_cells_of(const SnappedSurfaces& snapped, const Lattice& lattice, std::uint32_t triangle,
                  std::pair<int, int> layers, double margin, Entries& entries) {
  std::array<glm::dvec3, 3> corner;
  for (int k = 0; k < 3; ++k) {
    const auto& p = snapped.position[snapped.surfaces->triangle[triangle][k]];
    corner[static_cast<std::size_t>(k)] = glm::dvec3(p[0], p[1], p[2]) / static_cast<double>(lattice.units());
  }
  const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double reach = (0.5 + margin) * (std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z));
  glm::ivec3 low(glm::floor(glm::min(corner[0], glm::min(corner[1], corner[2])) - margin));
  glm::ivec3 high(glm::floor(glm::max(corner[0], glm::max(corner[1], corner[2])) + margin));
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::max(low[axis], 0);
    high[axis] = std::min(high[axis], lattice.count[static_cast<std::size_t>(axis)] - 2);
  }
  low.z = std::max(low.z, layers.first);
  high.z = std::min(high.z, layers.second - 1);
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const double height = glm::dot(normal, glm::dvec3(x + 0.5, y + 0.5, z + 0.5) - corner[0]);
        if (std::fabs(height) > reach) continue;
        entries.emplace_back((z * lattice.count[1] + y) * lattice.count[0] + x, triangle);
      }
    }
  }
}

}  // namespace

CellTriangles::CellTriangles(const SnappedSurfaces& snapped, const Lattice& lattice, double margin, Threads threads) {
  // Find the cells of every triangle, by layers.
  const int cells_z = lattice.count[2] - 1, slabs = std::min(slab_count, cells_z);
  std::vector<std::pair<int, int>> layers;
  for (int i = 0; i < slabs; ++i) layers.emplace_back(cells_z * i / slabs, cells_z * (i + 1) / slabs);
  std::vector<std::uint32_t> all(snapped.surfaces->triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  const auto triangles = triangles_by_planes(snapped, all, lattice, layers);
  std::vector<Entries> entries(layers.size());
  const auto plane = static_cast<std::size_t>(lattice.count[0] * lattice.count[1]);
  first_.assign(plane * static_cast<std::size_t>(lattice.count[2]) + 1, 0);
  parallel_for(layers.size(), threads, [&](std::size_t i) {
    for (const std::uint32_t t : triangles[i]) add_cells_of(snapped, lattice, t, layers[i], margin, entries[i]);
    for (const auto& [cell, triangle] : entries[i]) ++first_[cell + 1];
  });

  // Turn counts into places, and fill them.
  std::vector<std::uint32_t> before{0};
  for (const Entries& slab : entries) before.push_back(before.back() + static_cast<std::uint32_t>(slab.size()));
  triangle_.resize(before.back());
  parallel_for(layers.size(), threads, [&](std::size_t i) {
    const std::size_t begin = plane * static_cast<std::size_t>(layers[i].first);
    const std::size_t end = plane * static_cast<std::size_t>(layers[i].second);
    std::uint32_t sum = before[i];
    for (std::size_t cell = begin; cell < end; ++cell) sum += std::exchange(first_[cell + 1], sum);
    for (const auto& [cell, triangle] : entries[i]) triangle_[first_[cell + 1]++] = triangle;
  });
  std::fill(first_.begin() + static_cast<std::ptrdiff_t>(plane * static_cast<std::size_t>(cells_z)) + 1, first_.end(),
            before.back());
}

}  // namespace pomona
