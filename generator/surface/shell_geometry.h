// What a shell encloses.
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

/// Tells which shells lie in which. Asking costs time in proportion to the outer shell's size; a budget keeps
/// hostile files from asking without end.
class Containment {
 public:
  /// \param solid_angles the budget: of so many triangles; as it is, some ten seconds
  explicit Containment(const DiffusionSurfaces& surfaces, double solid_angles = 4e8)
      : surfaces_(surfaces), solid_angles_left_(solid_angles) {}

  /// By the mean winding number of some of the inner shell's triangles, so that touching in places, and rims
  /// that do not close, change nothing.
  /// \throws Error (bad_data) once the budget is spent.
  bool contains(const Shell& outer, const Shell& inner);

 private:
  double winding_number(const Shell& shell, const glm::dvec3& point);

  const DiffusionSurfaces& surfaces_;
  double solid_angles_left_;
};

}  // namespace pomona
