// The distance of a point from all surfaces, which each step of a walk on spheres needs.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/walk/frame_distance.h"
#include "generator/diffusion/walk/triangle_frames.h"

namespace pomona {

/// An octree of a cube around the surfaces. Each of the smallest cells has the groups of triangles that can be nearest
/// to any of its points, or lies so far from all that a bound suffices. Lengths are normalised.
class EmptyBalls {
 public:
  /// Half the edge of the cube, in which points may lie.
  static constexpr double half_edge = 1.05;

  /// An upper bound of the rounding error of a distance in single precision.
  static constexpr double slack = 1e-6;

  EmptyBalls(TriangleFrames frames, Threads threads);

  const TriangleFrames& frames() const { return frames_; }

  /// The radius of a ball around `point` that no surface reaches into, 0 or more: `slack` less than the distance to
  /// the nearest surface where that is small, at least 0.6 of it elsewhere.
  double radius_at(const glm::dvec3& point) const;

  /// The triangles at most a few `slack` farther than the nearest, as ascending indices into the surfaces.
  std::vector<std::uint32_t> nearest_triangles(const glm::dvec3& point) const;

 private:
  struct Cell {
    float distance = 0;       ///< distance from the cell's middle to the nearest surface
    std::uint32_t first = 0;  ///< index of its eight children, or of its groups, nearest first
    std::uint32_t count = 0;  ///< number of its groups, or one of the following
  };
  static constexpr std::uint32_t is_divided = 0xffffffff;
  static constexpr std::uint32_t is_far = 0xfffffffe;

  /// The octree of one cell of the coarse grid; its cell 0 is that cell.
  struct Branch {
    std::vector<Cell> cells;
    std::vector<NearGroup> near;
  };
  struct Place {
    const Branch* branch;
    const Cell* cell;
    float from_middle;  ///< distance from the point to the cell's middle
  };

  Branch grown(const glm::vec3& middle) const;
  void divide(Branch& branch, std::size_t cell, const glm::vec3& middle, int level,
              std::vector<NearGroup> candidates) const;
  Place place_of(const glm::vec3& point) const;

  TriangleFrames frames_;
  std::vector<Branch> branches_;
};

}  // namespace pomona
