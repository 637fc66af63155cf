// Signed distances to a closed mesh at the nodes of a grid: settling finds contacts by them.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/box.h"

namespace pomona {

struct DistanceGridOptions {
  int cells = 40000;        ///< number of cells, about
  double max_width = 1e30;  ///< largest width of a cell, metres, for thin walls; `max_cells` goes before it
  int max_cells = 400000;   ///< largest number of cells
};

/// Distances in single precision, negative inside. They are exact beside the surface, and nearly exact farther away.
class DistanceGrid {
 public:
  DistanceGrid() = default;

  /// \param position metres; no two are equal.
  /// \param triangle of a mesh that is closed, or has small holes only.
  DistanceGrid(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle,
               const DistanceGridOptions& options = {});

  /// The distance in metres, interpolated linearly between the nodes. Outside the grid it is a lower bound.
  float value(const glm::vec3& point) const;

  /// The direction in which the distance grows, of length 1.
  glm::vec3 direction(const glm::vec3& point) const;

  /// Points nearer to the surface than this, metres, lie in the grid.
  float reach() const { return reach_; }

  std::span<const float> values() const { return values_; }

 private:
  struct Mesh;
  void choose_cells(const Box<double>& box, const DistanceGridOptions& options);
  void measure_beside(const Mesh& mesh, std::vector<glm::vec3>& nearest);
  void spread(std::vector<glm::vec3>& nearest);
  void sign(const Mesh& mesh);
  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count_.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count_.x) +
           static_cast<std::size_t>(x);
  }

  glm::ivec3 count_{0};  ///< number of nodes along each axis
  glm::vec3 origin_{0};  ///< the first node, metres
  float width_ = 1;      ///< distance between two nodes, metres
  float per_metre_ = 1;  ///< 1 / width_
  float reach_ = 0;      ///< see reach()
  std::vector<float> values_;
};

inline float DistanceGrid::value(const glm::vec3& point) const {
  const glm::vec3 cell = (point - origin_) * per_metre_;
  const glm::vec3 last(glm::vec3(count_ - 1));
  if (cell.x < 0 || cell.y < 0 || cell.z < 0 || cell.x >= last.x || cell.y >= last.y || cell.z >= last.z) {
    const glm::vec3 out = glm::max(glm::max(-cell, cell - last), glm::vec3(0));
    return reach_ + width_ * std::sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
  }

  // Trilinear interpolation between the eight nodes around the point.
  const glm::ivec3 low(cell);
  const glm::vec3 share = cell - glm::vec3(low);
  const float* const near = &values_[at(low.x, low.y, low.z)];
  const float* const far = near + static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y);
  const int row = count_.x;
  const auto between = [](float a, float b, float s) { return a + (b - a) * s; };
  const float front = between(between(near[0], near[1], share.x), between(near[row], near[row + 1], share.x), share.y);
  const float back = between(between(far[0], far[1], share.x), between(far[row], far[row + 1], share.x), share.y);
  return between(front, back, share.z);
}

}  // namespace pomona
