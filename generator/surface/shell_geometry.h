// The geometry of shells: volumes, and which shell lies in which.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/mesh/box.h"
#include "generator/mesh/enclosures.h"
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

/// Finds the shells around a shell. Closed ones are all tested at once, by a line upwards, which meets few of their
/// triangles. A test against an open one takes time in proportion to its size. A budget limits the time that a hostile
/// file can take.
class Containment {
 public:
  /// \param outer the shells that may lie around others
  /// \param triangles the budget: number of triangles that are tested in all; the default takes some ten seconds
  Containment(const DiffusionSurfaces& surfaces, const std::vector<Shell>& shells,
              const std::vector<std::size_t>& outer, double triangles = 4e8);

  /// The smallest outer shell that contains the shell, if there is one: by its volume, whichever way it faces; of equal
  /// ones the first. The mean winding number around some triangles of the inner shell decides. So shells that touch in
  /// places, and small open rims, do not matter.
  /// \throws Error (bad_data) once the budget is spent.
  std::optional<std::size_t> smallest_around(std::size_t shell);

 private:
  std::vector<glm::dvec3> samples_of(const Shell& shell) const;
  std::optional<std::size_t> smallest_closed(std::size_t shell, const std::vector<glm::dvec3>& samples);
  bool is_in_open(std::size_t open, const std::vector<glm::dvec3>& samples);
  bool is_in_bounds(std::size_t outer, std::size_t inner) const;
  bool is_smaller(std::size_t a, std::size_t b) const;
  double winding_number(const Shell& shell, const glm::dvec3& point);
  void spend(std::size_t triangles);

  const DiffusionSurfaces& surfaces_;
  const std::vector<Shell>& shells_;
  double triangles_left_;
  Enclosures closed_;
  std::vector<std::size_t> open_;  // the smallest first
};

}  // namespace pomona
