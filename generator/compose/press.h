// Lets neighbours flatten each other.
#pragma once

#include <vector>

#include "generator/compose/instance_pose.h"
#include "generator/compose/reach_table.h"

namespace pomona {

/// An instance where it lies.
struct PressedBody {
  const ReachTable* reach = nullptr;  ///< in its own frame
  InstancePose pose;

  glm::dvec3 heart() const { return pose(reach->heart()); }
};

/// Half of space in which a body stays, in its own frame: where dot(normal, p - heart) is at most `at`.
struct PressPlane {
  glm::dvec3 normal{0};
  double at = 0;
};

/// Half of space in the fruit's frame, of a neighbour that does not give way: beyond `point` towards `normal`.
struct PressWall {
  glm::dvec3 point{0}, normal{0};
};

/// The convex cell around a body's heart, and what it makes of the body. Towards each neighbour lies a plane through
/// the place between their hearts that is equally deep in both; cells of neighbours do not overlap. Each vertex is
/// drawn to the heart by a factor that depends on its direction alone, so layers within keep their order; and what has
/// its vertices in a convex cell has its facets there, so no skins cross, however coarse.
class PressCell {
 public:
  PressCell(const PressSketch& press, const std::vector<PressedBody>& bodies, std::size_t own,
            const std::vector<PressWall>& walls);

  /// Whether some neighbour's heart is so near that its cell has no room.
  bool is_crowded() const { return crowded_; }

  /// The share of its way from the heart that is left to what lies in a direction, 0..1.
  double share(const glm::dvec3& direction) const;

  DiffusionSurfaces pressed(DiffusionSurfaces body) const;

 private:
  void add(const glm::dvec3& normal, double at);

  /// The factor to the nearest plane for a vertex at `way` from the heart; above 1 within the cell.
  double to_plane(const glm::dvec3& way) const;

  const ReachTable& reach_;
  double soft_;
  bool crowded_ = false;
  std::vector<PressPlane> planes_;
};

}  // namespace pomona
