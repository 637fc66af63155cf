// The geometry of shells: volumes, and which shell lies in which.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/mesh/box.h"
#include "generator/surface/shells.h"

namespace pomona {

/// One shell by itself.
struct Shell {
  std::vector<glm::uvec3> triangles;  ///< welded, facing air
  Box<double> bounds;
  double volume = 0;  ///< cubic metres; negative where air is inside (a cavity wall)
  bool closed = true;
};

/// Every shell, in order.
std::vector<Shell> measured_shells(const DiffusionSurfaces& surfaces, const Shells& shells);

/// Tests which shells lie in which. A test takes time proportional to the size of the outer shell; a budget limits the
/// time that a hostile file can take.
class Containment {
 public:
  /// \param solid_angles the budget: number of triangles that are tested in all; the default takes some ten seconds
  explicit Containment(const DiffusionSurfaces& surfaces, double solid_angles = 4e8)
      : surfaces_(surfaces), solid_angles_left_(solid_angles) {}

  /// Decides by the mean winding number around some of the inner shell's triangles. So shells that touch in places, and
  /// small open rims, do not matter.
  /// \throws Error (bad_data) once the budget is spent.
  bool contains(const Shell& outer, const Shell& inner);

 private:
  double winding_number(const Shell& shell, const glm::dvec3& point);

  const DiffusionSurfaces& surfaces_;
  double solid_angles_left_;
};

}  // namespace pomona
