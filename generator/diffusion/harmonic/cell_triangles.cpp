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

/// What lies in some layers of cells.
struct Slab {
  std::size_t first_cell = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> entry;  ///< cell, from the first on, and triangle; as found
  SparseSet filled;                                            ///< of its cells
  std::uint32_t filled_count = 0;
};

void add_cells_of(const SnappedSurfaces& snapped, const Lattice& lattice, std::uint32_t triangle,
                  std::pair<int, int> layers, double margin, Slab& slab) {
  const double unit = 1.0 / static_cast<double>(lattice.units());  // a power of 2
  std::array<glm::dvec3, 3> corner;
  for (int k = 0; k < 3; ++k) {
    const auto& p = snapped.position[snapped.surfaces->triangle[triangle][k]];
    corner[static_cast<std::size_t>(k)] = unit * glm::dvec3(p[0], p[1], p[2]);
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
  const auto height_along = [&](int axis, int cell) { return normal[axis] * (cell + 0.5 - corner[0][axis]); };
  for (int z = low.z; z <= high.z; ++z) {
    const double height_z = height_along(2, z);
    for (int y = low.y; y <= high.y; ++y) {
      const double height_y = height_along(1, y);
      const int row = ((z - layers.first) * lattice.count[1] + y) * lattice.count[0];
      for (int x = low.x; x <= high.x; ++x) {
        const double height = height_along(0, x) + height_y + height_z;
        if (std::fabs(height) > reach) continue;
        slab.entry.emplace_back(row + x, triangle);
        slab.filled.add(static_cast<std::size_t>(row + x));
      }
    }
  }
}

/// Where each filled cell's triangles begin, and the triangles, both from `before` on.
void fill_in(Slab& slab, std::uint32_t before, std::uint32_t* first, std::uint32_t* triangle) {
  for (auto& [cell, t] : slab.entry) {
    cell = slab.filled.place(cell);
    ++first[cell];
  }
  std::uint32_t sum = before;
  for (std::uint32_t c = 0; c < slab.filled_count; ++c) sum += std::exchange(first[c], sum);
  for (const auto& [cell, t] : slab.entry) triangle[first[cell]++] = t;

  // Each has moved to where the next begins.
  for (std::uint32_t c = slab.filled_count; c-- > 1;) first[c] = first[c - 1];
  if (slab.filled_count > 0) first[0] = before;
}

}  // namespace

void SparseSet::add_all(const SparseSet& others, std::size_t first) {
  const std::size_t shift = first % 64;
  for (std::size_t w = 0; w < others.words_.size(); ++w) {
    const std::uint64_t bits = others.words_[w].bits;
    if (bits == 0) continue;
    words_[first / 64 + w].bits |= bits << shift;
    const std::uint64_t rest = shift > 0 ? bits >> (64 - shift) : 0;
    if (rest != 0) words_[first / 64 + w + 1].bits |= rest;
  }
}

std::uint32_t SparseSet::count() {
  std::uint32_t sum = 0;
  for (Word& word : words_) {
    word.before = sum;
    sum += count_of_bits(word.bits);
  }
  return sum;
}

CellTriangles::CellTriangles(const SnappedSurfaces& snapped, const Lattice& lattice, double margin, Threads threads) {
  // Find the cells of every triangle, by layers.
  const int cells_z = lattice.count[2] - 1, slab_number = std::min(slab_count, cells_z);
  std::vector<std::pair<int, int>> layers;
  for (int i = 0; i < slab_number; ++i) layers.emplace_back(cells_z * i / slab_number, cells_z * (i + 1) / slab_number);
  std::vector<std::uint32_t> all(snapped.surfaces->triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  const auto triangles = triangles_by_planes(snapped, all, lattice, layers);
  std::vector<Slab> slabs(layers.size());
  const auto plane = static_cast<std::size_t>(lattice.count[0]) * static_cast<std::size_t>(lattice.count[1]);
  parallel_for(layers.size(), threads, [&](std::size_t i) {
    const auto [first, end] = layers[i];
    slabs[i].first_cell = plane * static_cast<std::size_t>(first);
    slabs[i].filled = SparseSet(plane * static_cast<std::size_t>(end - first));
    for (const std::uint32_t t : triangles[i]) add_cells_of(snapped, lattice, t, layers[i], margin, slabs[i]);
    slabs[i].filled_count = slabs[i].filled.count();
  });

  // Give each slab its place among all, and let it fill that.
  filled_ = SparseSet(plane * static_cast<std::size_t>(lattice.count[2]));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> before{{0, 0}};  // filled cells and entries
  for (const Slab& slab : slabs) {
    filled_.add_all(slab.filled, slab.first_cell);
    before.emplace_back(before.back().first + slab.filled_count,
                        before.back().second + static_cast<std::uint32_t>(slab.entry.size()));
  }
  filled_.count();
  first_.resize(before.back().first + 1);
  first_.back() = before.back().second;
  triangle_.resize(before.back().second);
  parallel_for(slabs.size(), threads, [&](std::size_t i) {
    fill_in(slabs[i], before[i].second, first_.data() + before[i].first, triangle_.data());
  });
}

}  // namespace pomona
