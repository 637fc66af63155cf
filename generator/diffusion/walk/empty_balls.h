// How far a point is from all surfaces: what each step of a walk on spheres needs to know.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/diffusion/walk/frame_distance.h"
#include "generator/diffusion/walk/triangle_frames.h"

namespace pomona {

/// A cube around the surfaces, halved again and again. Each of the smallest cells knows the groups of triangles
/// that can be nearest to any of its points; or it lies so far from all that a bound will do. Normalised lengths.
class EmptyBalls {
 public:
  /// Half the edge of the cube: what may be asked about.
  static constexpr double half_edge = 1.05;

  /// More than what single precision takes from a distance.
  static constexpr double slack = 1e-6;

  EmptyBalls(TriangleFrames frames, Threads threads);

  const TriangleFrames& frames() const { return frames_; }

  /// The radius of a ball around `point` that no surface reaches into, 0 or more: `slack` less than the distance to
  /// the nearest surface where that is small, at least 0.6 of it elsewhere.
  double radius_at(const glm::dvec3& point) const;

  /// The triangles no more than a few `slack` farther than the nearest, by index into the surfaces, ascending.
  std::vector<std::uint32_t> nearest_triangles(const glm::dvec3& point) const;

 private:
  struct Cell {
    float distance = 0;       ///< from the cell's middle to the nearest surface
    std::uint32_t first = 0;  ///< its eight children, or its groups, nearest first
    std::uint32_t count = 0;  ///< its groups, or one of the following
  };
  static constexpr std::uint32_t is_divided = 0xffffffff;
  static constexpr std::uint32_t is_far = 0xfffffffe;

  /// All that lies in one cell of the coarse grid over the cube; cell 0 is that cell itself.
  struct Branch {
    std::vector<Cell> cells;
    std::vector<NearGroup> near;
  };
  struct Place {
    const Branch* branch;
    const Cell* cell;
    float from_middle;  ///< from the point to the cell's middle
  };

  Branch grown(const glm::vec3& middle) const;
  void divide(Branch& branch, std::size_t cell, const glm::vec3& middle, int level,
              std::vector<NearGroup> candidates) const;
  Place place_of(const glm::vec3& point) const;

  TriangleFrames frames_;
  std::vector<Branch> branches_;
};

}  // namespace pomona
