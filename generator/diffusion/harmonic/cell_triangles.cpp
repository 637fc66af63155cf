#include "generator/diffusion/harmonic/cell_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/cut_arms.h"

namespace pomona {

namespace {

/// Number of slabs.
constexpr int max_slabs = 16;

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

CellTriangleFinder::CellTriangleFinder(const SnappedSurfaces& snapped, const Lattice& lattice, double margin)
    : snapped_(snapped),
      lattice_(lattice),
      margin_(margin),
      plane_(static_cast<std::size_t>(lattice.count[0]) * static_cast<std::size_t>(lattice.count[1])) {
  const int cells_z = lattice.count[2] - 1, slab_number = std::min(max_slabs, cells_z);
  std::vector<std::pair<int, int>> layers;
  for (int i = 0; i < slab_number; ++i) layers.emplace_back(cells_z * i / slab_number, cells_z * (i + 1) / slab_number);
  std::vector<std::uint32_t> all(snapped.surfaces->triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  auto near = triangles_by_planes(snapped, all, lattice, layers);
  slabs_.resize(layers.size());
  for (std::size_t i = 0; i < slabs_.size(); ++i) {
    slabs_[i].layers = layers[i];
    slabs_[i].near = std::move(near[i]);
  }
}

void CellTriangleFinder::find(std::size_t i) {
  Slab& slab = slabs_[i];
  const auto [first, end] = slab.layers;
  slab.first_cell = plane_ * static_cast<std::size_t>(first);
  slab.filled = SparseSet(plane_ * static_cast<std::size_t>(end - first));
  for (const std::uint32_t t : slab.near) add_cells_of(t, slab);
  slab.filled_count = slab.filled.count();
}

void CellTriangleFinder::add_cells_of(std::uint32_t triangle, Slab& slab) const {
  const double unit = 1.0 / static_cast<double>(lattice_.units());  // a power of 2
  std::array<glm::dvec3, 3> corner;
  for (int k = 0; k < 3; ++k) {
    const auto& p = snapped_.position[snapped_.surfaces->triangle[triangle][k]];
    corner[static_cast<std::size_t>(k)] = unit * glm::dvec3(p[0], p[1], p[2]);
  }
  const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double reach = (0.5 + margin_) * (std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z));
  glm::ivec3 low(glm::floor(glm::min(corner[0], glm::min(corner[1], corner[2])) - margin_));
  glm::ivec3 high(glm::floor(glm::max(corner[0], glm::max(corner[1], corner[2])) + margin_));
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::max(low[axis], 0);
    high[axis] = std::min(high[axis], lattice_.count[static_cast<std::size_t>(axis)] - 2);
  }
  low.z = std::max(low.z, slab.layers.first);
  high.z = std::min(high.z, slab.layers.second - 1);
  const auto height_along = [&](int axis, int cell) { return normal[axis] * (cell + 0.5 - corner[0][axis]); };
  for (int z = low.z; z <= high.z; ++z) {
    const double height_z = height_along(2, z);
    for (int y = low.y; y <= high.y; ++y) {
      const double height_y = height_along(1, y);
      const int row = ((z - slab.layers.first) * lattice_.count[1] + y) * lattice_.count[0];
      for (int x = low.x; x <= high.x; ++x) {
        const double height = height_along(0, x) + height_y + height_z;
        if (std::fabs(height) > reach) continue;
        slab.entry.emplace_back(row + x, triangle);
        slab.filled.add(static_cast<std::size_t>(row + x));
      }
    }
  }
}

void CellTriangleFinder::place() {
  cells_.filled_ = SparseSet(plane_ * static_cast<std::size_t>(lattice_.count[2]));
  std::uint32_t filled = 0, entries = 0;
  for (Slab& slab : slabs_) {
    cells_.filled_.add_all(slab.filled, slab.first_cell);
    slab.filled_before = filled;
    slab.entries_before = entries;
    filled += slab.filled_count;
    entries += static_cast<std::uint32_t>(slab.entry.size());
  }
  cells_.filled_.count();
  cells_.first_.resize(filled + 1);
  cells_.first_.back() = entries;
  cells_.triangle_.resize(entries);
}

void CellTriangleFinder::fill(std::size_t i) {
  // Count each filled cell's triangles, so that each cell gets its place.
  Slab& slab = slabs_[i];
  std::uint32_t* first = cells_.first_.data() + slab.filled_before;
  for (auto& [cell, t] : slab.entry) {
    cell = slab.filled.place(cell);
    ++first[cell];
  }
  std::uint32_t sum = slab.entries_before;
  for (std::uint32_t c = 0; c < slab.filled_count; ++c) sum += std::exchange(first[c], sum);
  for (const auto& [cell, t] : slab.entry) cells_.triangle_[first[cell]++] = t;

  // Each start index has moved to the start of the next cell.
  for (std::uint32_t c = slab.filled_count; c-- > 1;) first[c] = first[c - 1];
  if (slab.filled_count > 0) first[0] = slab.entries_before;
}

}  // namespace pomona
