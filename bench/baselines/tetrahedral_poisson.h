// The solve of Poisson's equation over tetrahedra that the paper compares with (section 3.2, Figure 4).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona::bench {

struct PoissonOptions {
  double cell_size = 0.025;  ///< about the longest edge of a tetrahedron, in parts of the surfaces' size (diagonal)
};

/// The cost, and how well the equations are met.
struct PoissonCost {
  std::size_t tetrahedra = 0;
  std::size_t unknowns = 0;    ///< number of corners that no surface colours
  double meshing_seconds = 0;  ///< together with the next: the paper's precomputation
  double solving_seconds = 0;
  std::size_t storage_bytes = 0;  ///< memory kept for any number of cuts: positions, corners, colours, neighbours
  double residual = 0;            ///< largest over channels, relative to the right-hand side
  double overshoot = 0;           ///< how far colours leave the surfaces' hull; obtuse angles allow for a little
};

/// Linear finite elements with the surfaces' colours as boundary values. Corners on surfaces are doubled, so that
/// each side keeps its own; at a rim both sides' mean holds. Beyond open ends the boundary is free.
class TetrahedralPoisson {
 public:
  /// \throws Error (bad_data) as make_surface_tree() does. `surfaces` must outlive it.
  TetrahedralPoisson(const DiffusionSurfaces& surfaces, const PoissonOptions& options = {});
  ~TetrahedralPoisson();

  /// Why there is no solution, in plain words (surfaces that cross, an open skin); empty if there is one.
  const std::string& why_not() const { return why_not_; }
  const PoissonCost& cost() const { return cost_; }

  /// Linear colours at `points` (metres). Next to a surface that the tetrahedra only approximate, and outside of all
  /// tetrahedra, it is the colour of the nearest side. Only if why_not() is empty.
  std::vector<Color> at(std::span<const glm::vec3> points) const;

 private:
  struct Solution;
  std::unique_ptr<const Solution> solution_;
  std::string why_not_;
  PoissonCost cost_;
};

}  // namespace pomona::bench
