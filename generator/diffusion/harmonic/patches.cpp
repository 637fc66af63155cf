#include "generator/diffusion/harmonic/patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/mesh/connected_vertices.h"

namespace pomona {

namespace {

double half_thickness(const DiffusionSurfaces& surfaces, std::span<const std::uint32_t> triangles) {
  const glm::dvec3 origin(surfaces.position[surfaces.triangle[triangles.front()].x]);
  double volume = 0, area = 0;
  for (const std::uint32_t t : triangles) {
    const glm::uvec3& v = surfaces.triangle[t];
    const glm::dvec3 a = glm::dvec3(surfaces.position[v.x]) - origin, b = glm::dvec3(surfaces.position[v.y]) - origin,
                     c = glm::dvec3(surfaces.position[v.z]) - origin;
    volume += glm::dot(a, glm::cross(b, c)) / 6;
    area += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return area > 0 ? 3 * std::fabs(volume) / area : 0;
}

/// The first and the last brick within `margin` cells of a triangle.
std::pair<Node, Node> bricks_around(const SnappedSurfaces& snapped, std::uint32_t triangle, const Lattice& coarse,
                                    int margin) {
  const Node count = bricks_of(coarse);
  const glm::uvec3& v = snapped.surfaces->triangle[triangle];
  Node low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t x = snapped.position[v.x][a], y = snapped.position[v.y][a], z = snapped.position[v.z][a];
    const auto first = static_cast<int>(std::min({x, y, z}) >> coarse.unit_bits) - margin;
    const auto last = static_cast<int>(std::max({x, y, z}) >> coarse.unit_bits) + margin;
    low[a] = std::clamp(first / brick[a], 0, count[a] - 1);
    high[a] = std::clamp(last / brick[a], 0, count[a] - 1);
  }
  return {low, high};
}

std::vector<std::uint8_t> covered_bricks(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles,
                                         const Lattice& coarse, int margin) {
  const Node count = bricks_of(coarse);
  std::vector<std::uint8_t> is_covered(
      static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1] * count[2]), 0);
  for (const std::uint32_t t : triangles) {
    const auto [low, high] = bricks_around(snapped, t, coarse, margin);
    for (int z = low[2]; z <= high[2]; ++z) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int x = low[0]; x <= high[0]; ++x) is_covered[brick_index({x, y, z}, count)] = 1;
      }
    }
  }
  return is_covered;
}

/// The triangles with a covered brick within one cell of them.
std::vector<std::uint32_t> triangles_near(const SnappedSurfaces& snapped, const Lattice& coarse,
                                          const std::vector<std::uint8_t>& is_covered) {
  const Node count = bricks_of(coarse);
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < snapped.surfaces->triangle_count(); ++t) {
    const auto [low, high] = bricks_around(snapped, t, coarse, 1);
    bool is_near = false;
    for (int z = low[2]; z <= high[2] && !is_near; ++z) {
      for (int y = low[1]; y <= high[1] && !is_near; ++y) {
        for (int x = low[0]; x <= high[0] && !is_near; ++x) is_near = is_covered[brick_index({x, y, z}, count)];
      }
    }
    if (is_near) near.push_back(t);
  }
  return near;
}

/// The nodes of the finer lattice in covered bricks: 9 x 5 x 5 each, sharing borders.
void add_nodes(PatchNodes& patch, const Node& bricks, const Lattice& fine) {
  const auto rows = static_cast<std::size_t>(fine.count[1] * fine.count[2]);
  std::vector<ColumnMask> full(rows, 0);
  for (int z = 0; z < bricks[2]; ++z) {
    for (int y = 0; y < bricks[1]; ++y) {
      ColumnMask columns = 0;
      for (int x = 0; x < bricks[0]; ++x) {
        if (patch.is_covered[brick_index({x, y, z}, bricks)]) columns |= ColumnMask{1} << x;
      }
      for (int row_z = 4 * z; row_z <= 4 * z + 4; ++row_z) {
        for (int row_y = 4 * y; row_y <= 4 * y + 4; ++row_y) {
          full[static_cast<std::size_t>(row_z * fine.count[1] + row_y)] |= columns;
        }
      }
    }
  }

  // The last border node of a brick is the first node of the next block.
  std::vector<ColumnMask> stored(rows);
  for (std::size_t row = 0; row < rows; ++row) stored[row] = full[row] | full[row] << 1;
  patch.blocks = SparseBlocks(fine.count, stored);
  for (std::size_t r = 0; r < patch.blocks.size(); ++r) {
    const NodeBlock& block = patch.blocks[r];
    const ColumnMask here = full[static_cast<std::size_t>(block.z * fine.count[1] + block.y)];
    patch.members.push_back(here >> block.column & 1 ? 255 : 1);
  }
}

}  // namespace

Node bricks_of(const Lattice& lattice) {
  Node count{};
  for (std::size_t a = 0; a < 3; ++a) count[a] = (lattice.count[a] - 1) / brick[a];
  return count;
}

std::size_t brick_index(const Node& at, const Node& count) {
  return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(at[1])) *
             static_cast<std::size_t>(count[0]) +
         static_cast<std::size_t>(at[0]);
}

std::vector<SmallBody> small_bodies(const DiffusionSurfaces& surfaces, double longest) {
  // Find what is connected, and how long it is.
  DisjointSets connected = connected_vertices(surfaces.vertex_count(), surfaces.triangle);
  std::vector<glm::vec3> low(surfaces.position), high(surfaces.position);
  for (std::uint32_t v = 0; v < surfaces.vertex_count(); ++v) {
    const std::uint32_t root = connected.root(v);
    low[root] = glm::min(low[root], surfaces.position[v]);
    high[root] = glm::max(high[root], surfaces.position[v]);
  }

  // Collect the triangles of the parts that are short enough.
  std::vector<SmallBody> bodies;
  std::vector<std::int32_t> body(surfaces.vertex_count(), -1);
  for (std::uint32_t t = 0; t < surfaces.triangle_count(); ++t) {
    const std::uint32_t root = connected.root(surfaces.triangle[t].x);
    if (glm::length(glm::dvec3(high[root]) - glm::dvec3(low[root])) > longest) continue;
    if (body[root] < 0) {
      body[root] = static_cast<std::int32_t>(bodies.size());
      bodies.emplace_back();
    }
    bodies[static_cast<std::size_t>(body[root])].triangle.push_back(t);
  }
  for (SmallBody& small : bodies) small.half_thickness = half_thickness(surfaces, small.triangle);
  return bodies;
}

PatchNodes patch_around(const SnappedSurfaces& snapped, std::span<const std::uint32_t> triangles, const Lattice& coarse,
                        int margin, const PatchNodes* within, std::span<const std::uint8_t> wanted) {
  const Node count = bricks_of(coarse);
  PatchNodes patch;
  patch.is_covered = covered_bricks(snapped, triangles, coarse, margin);
  for (std::size_t b = 0; b < wanted.size(); ++b) patch.is_covered[b] |= wanted[b];
  if (within != nullptr) {
    // Eight bricks of this lattice make one of the lattice before.
    for (int z = 0; z < count[2]; ++z) {
      for (int y = 0; y < count[1]; ++y) {
        for (int x = 0; x < count[0]; ++x) {
          const Node around{x / 2, y / 2, z / 2};
          const Node outer{count[0] / 2, count[1] / 2, count[2] / 2};
          if (!within->is_covered[brick_index(around, outer)]) patch.is_covered[brick_index({x, y, z}, count)] = 0;
        }
      }
    }
  }
  add_nodes(patch, count, halved(coarse));
  patch.triangle = triangles_near(snapped, coarse, patch.is_covered);
  return patch;
}

}  // namespace pomona
