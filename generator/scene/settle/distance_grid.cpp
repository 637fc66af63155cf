#include "generator/scene/settle/distance_grid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/ray_passes.h"
#include "generator/mesh/triangle_distance.h"

namespace pomona {

namespace {

constexpr float unknown = 1e30f;

float squared(const glm::vec3& v) { return glm::dot(v, v); }

}  // namespace

/// The triangles by their corners, and the box around them.
struct DistanceGrid::Mesh {
  std::vector<TriangleCorners> triangle;
  Box<double> box;
};

DistanceGrid::DistanceGrid(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle,
                           const DistanceGridOptions& options) {
  Mesh mesh;
  for (const glm::uvec3& t : triangle) {
    mesh.triangle.push_back({position[t.x], position[t.y], position[t.z]});
    for (const glm::dvec3& corner : mesh.triangle.back()) mesh.box.add(corner);
  }
  if (mesh.triangle.empty()) return;
  choose_cells(mesh.box, options);
  const glm::dvec3 nodes(count_);
  values_.assign(static_cast<std::size_t>(nodes.x * nodes.y * nodes.z), unknown);

  // The values are squared until their signs are known.
  std::vector<glm::vec3> nearest(values_.size());
  measure_beside(mesh, nearest);
  spread(nearest);
  for (float& value : values_) value = std::sqrt(value);
  sign(mesh);
}

void DistanceGrid::choose_cells(const Box<double>& box, const DistanceGridOptions& options) {
  // A few rounds find the width at which the box with its margin has as many cells as asked for.
  const double size = glm::length(box.size());
  const glm::dvec3 extent = glm::max(box.size(), glm::dvec3(0.02 * size));
  const auto margin = [&](double width) { return std::max(2 * width, 0.05 * size); };
  double width = reproducible::cbrt(extent.x * extent.y * extent.z / options.cells);
  for (int round = 0; round < 4; ++round) {
    const glm::dvec3 all = extent + 2 * margin(width);
    width *= reproducible::cbrt(all.x * all.y * all.z / (width * width * width) / options.cells);
  }

  // Finer where that is asked for, within bounds.
  const double min_width = width * reproducible::cbrt(static_cast<double>(options.cells) / options.max_cells);
  width = std::max(std::min(width, options.max_width), min_width);
  width_ = static_cast<float>(width);
  per_metre_ = 1 / width_;
  reach_ = static_cast<float>(margin(width));
  origin_ = glm::vec3(box.low - margin(width));
  count_ = glm::ivec3(glm::ceil((extent + 2 * margin(width)) / width)) + 1;
}

/// Exact within about a cell of each triangle.
void DistanceGrid::measure_beside(const Mesh& mesh, std::vector<glm::vec3>& nearest) {
  const glm::dvec3 origin(origin_);
  const double width = width_;
  for (const TriangleCorners& t : mesh.triangle) {
    const Box<double> box = box_around(t[0], t[1], t[2]);
    const glm::ivec3 low = glm::max(glm::ivec3(glm::floor((box.low - origin) / width - 0.6)), glm::ivec3(0));
    const glm::ivec3 high = glm::min(glm::ivec3(glm::ceil((box.high - origin) / width + 0.6)), count_ - 1);
    for (int z = low.z; z <= high.z; ++z) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
          const glm::dvec3 point = origin + width * glm::dvec3(x, y, z);
          const glm::dvec3 on = nearest_on_triangle(point, t);
          const auto distance = static_cast<float>(glm::dot(point - on, point - on));
          const std::size_t node = at(x, y, z);
          if (distance < values_[node]) values_[node] = distance, nearest[node] = glm::vec3(on);
        }
      }
    }
  }
}

/// Farther away: nearest points are handed on from node to node, in eight sweeps [after Danielsson 1980].
void DistanceGrid::spread(std::vector<glm::vec3>& nearest) {
  for (int sweep = 0; sweep < 8; ++sweep) {
    const glm::ivec3 step((sweep & 1) != 0 ? -1 : 1, (sweep & 2) != 0 ? -1 : 1, (sweep & 4) != 0 ? -1 : 1);
    const auto place = [&](int i, int axis) { return step[axis] > 0 ? i : count_[axis] - 1 - i; };
    for (int k = 0; k < count_.z; ++k) {
      for (int j = 0; j < count_.y; ++j) {
        for (int i = 0; i < count_.x; ++i) {
          const int x = place(i, 0), y = place(j, 1), z = place(k, 2);
          const std::size_t node = at(x, y, z);
          const glm::vec3 point = origin_ + width_ * glm::vec3(x, y, z);
          const auto ask = [&](std::size_t other) {
            if (values_[other] >= unknown) return;
            const float distance = squared(point - nearest[other]);
            if (distance < values_[node]) values_[node] = distance, nearest[node] = nearest[other];
          };
          if (i > 0) ask(at(x - step.x, y, z));
          if (j > 0) ask(at(x, y - step.y, z));
          if (k > 0) ask(at(x, y, z - step.z));
        }
      }
    }
  }
}

/// Inside is what the mesh winds around, seen along two of the three axes at least: so small holes do not leak.
void DistanceGrid::sign(const Mesh& mesh) {
  std::vector<std::uint8_t> votes(values_.size());
  std::vector<std::int16_t> turns(values_.size());
  const glm::dvec3 origin(origin_);
  const double width = width_;
  const auto row = static_cast<std::size_t>(count_.x);
  const std::array<std::size_t, 3> stride{1, row, row * static_cast<std::size_t>(count_.y)};
  for (int along = 0; along < 3; ++along) {
    const int u = (along + 1) % 3, v = (along + 2) % 3;
    const auto node = [&](int iu, int iv, int i) {
      return static_cast<std::size_t>(iu) * stride[static_cast<std::size_t>(u)] +
             static_cast<std::size_t>(iv) * stride[static_cast<std::size_t>(v)] +
             static_cast<std::size_t>(i) * stride[static_cast<std::size_t>(along)];
    };

    // Each triangle turns the sign of the nodes before it on the lines that pass through it: noted at the last one.
    std::fill(turns.begin(), turns.end(), std::int16_t{0});
    for (const TriangleCorners& t : mesh.triangle) {
      const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
      if (normal[along] == 0) continue;
      const Box<double> box = box_around(t[0], t[1], t[2]);
      const glm::ivec3 low = glm::max(glm::ivec3(glm::floor((box.low - origin) / width)), glm::ivec3(0));
      const glm::ivec3 high = glm::min(glm::ivec3(glm::ceil((box.high - origin) / width)), count_ - 1);
      for (int iv = low[v]; iv <= high[v]; ++iv) {
        for (int iu = low[u]; iu <= high[u]; ++iu) {
          glm::dvec3 p = origin;
          p[u] += width * iu;
          p[v] += width * iv;
          if (!ray_passes(t, p, along)) continue;
          const double lean = normal[u] * (p[u] - t[0][u]) + normal[v] * (p[v] - t[0][v]);
          const double height = t[0][along] - lean / normal[along];
          const int last = std::min(static_cast<int>(std::ceil((height - p[along]) / width)) - 1, count_[along] - 1);
          if (last < 0) continue;
          std::int16_t& turn = turns[node(iu, iv, last)];
          turn = static_cast<std::int16_t>(turn + (normal[along] > 0 ? 1 : -1));
        }
      }
    }

    // Summed up from the far end of every line.
    for (int iv = 0; iv < count_[v]; ++iv) {
      for (int iu = 0; iu < count_[u]; ++iu) {
        int winding = 0;
        for (int i = count_[along] - 1; i >= 0; --i) {
          winding += turns[node(iu, iv, i)];
          if (winding > 0) ++votes[node(iu, iv, i)];
        }
      }
    }
  }
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (votes[i] >= 2) values_[i] = -values_[i];
}

glm::vec3 DistanceGrid::direction(const glm::vec3& p) const {
  const float e = 0.5f * width_;
  const glm::vec3 slope(value({p.x + e, p.y, p.z}) - value({p.x - e, p.y, p.z}),
                        value({p.x, p.y + e, p.z}) - value({p.x, p.y - e, p.z}),
                        value({p.x, p.y, p.z + e}) - value({p.x, p.y, p.z - e}));
  const float length = std::sqrt(squared(slope));
  return length > 1e-12f ? slope / length : glm::vec3(0, 1, 0);
}

}  // namespace pomona
