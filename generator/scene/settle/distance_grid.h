// Signed distances to a closed mesh at the nodes of a grid: what settling asks where two pieces meet.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/box.h"

namespace pomona {

struct DistanceGridOptions {
  int cells = 40000;        ///< about so many
  double finest = 1e30;     ///< metres: cells at most so wide, for thin walls,
  int most_cells = 400000;  ///< unless that takes more than these
};

/// Distances in single precision, exact beside the surface and nearly so farther away, negative inside.
class DistanceGrid {
 public:
  DistanceGrid() = default;

  /// \param position metres, equal ones welded. The mesh is closed, or closed but for small holes.
  DistanceGrid(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle,
               const DistanceGridOptions& options = {});

  /// Metres, between the nodes linearly; outside the grid at most the distance.
  float value(const glm::vec3& point) const;

  /// Where the distance grows, of length 1.
  glm::vec3 direction(const glm::vec3& point) const;

  /// Points nearer than this to the surface lie in the grid.
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

  glm::ivec3 count_{0};  ///< nodes along each axis
  glm::vec3 origin_{0};
  float width_ = 1, per_metre_ = 1, reach_ = 0;
  std::vector<float> values_;
};

inline float DistanceGrid::value(const glm::vec3& point) const {
  const glm::vec3 cell = (point - origin_) * per_metre_;
  const glm::vec3 last(glm::vec3(count_ - 1));
  if (cell.x < 0 || cell.y < 0 || cell.z < 0 || cell.x >= last.x || cell.y >= last.y || cell.z >= last.z) {
    const glm::vec3 out = glm::max(glm::max(-cell, cell - last), glm::vec3(0));
    return reach_ + width_ * std::sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
  }

  // Between the eight nodes around it, axis by axis.
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
