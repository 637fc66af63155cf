// The walls that grains keep clear of.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/enclosures.h"
#include "generator/surface/sweep/grain_pose.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// The ellipsoid in which a grain lies.
struct GrainBody {
  glm::dvec3 center{0};
  GrainPose pose;
};

/// What a wall asks of a body: nothing if the body is clear of it.
struct WallPush {
  glm::dvec3 by{0};  ///< moved by this, the body just touches the wall where it was deepest in
  double depth = 0;  ///< 0 = clear; in radii of the body
};

/// Closed meshes, each of which has an inside and an outside.
class GrainWalls {
 public:
  /// \param cell the width of the grid in which triangles are looked up: less than the length of a grain, metres.
  GrainWalls(const std::vector<SweptGrid>& meshes, double cell);

  /// The meshes that a place lies in, ascending.
  std::vector<std::uint32_t> around(const glm::dvec3& place) const;

  /// The push of the wall that is deepest in the body's way. \param home the meshes in which the body is to lie.
  WallPush deepest(const GrainBody& body, const std::vector<std::uint32_t>& home) const;

 private:
  struct Cell {
    std::int32_t x = 0, y = 0, z = 0;
    auto operator<=>(const Cell&) const = default;
  };
  Cell cell_of(const glm::dvec3& place) const;
  /// Calls visit(triangle) for all triangles that may meet the box; some of them more than once.
  template <typename Visit>
  void for_each_near(const glm::dvec3& low, const glm::dvec3& high, const Visit& visit) const;

  double cell_;
  std::vector<Enclosures::Triangle> triangles_;
  Enclosures enclosures_;
  std::vector<std::pair<Cell, std::uint32_t>> over_;  ///< triangles by the cells that their boxes meet, sorted
};

}  // namespace pomona
