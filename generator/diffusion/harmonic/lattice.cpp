#include "generator/diffusion/harmonic/lattice.h"

#include <algorithm>
#include <cmath>

namespace pomona {

Lattice lattice_around(const DiffusionSurfaces& surfaces, double spacing, int margin, int halvings,
                       const glm::dvec3& shift) {
  const Box<double> bounds = bounds_of(surfaces);
  const int step = 1 << halvings;
  Lattice lattice;
  lattice.spacing = spacing;
  lattice.unit_bits = base_unit_bits;
  for (int axis = 0; axis < 3; ++axis) {
    // Room for the margins and for any shift, then up to the next multiple.
    const int wanted = static_cast<int>(std::ceil(bounds.size()[axis] / spacing)) + 2 * margin + 1;
    const int cells = (wanted + step - 1) / step * step;
    lattice.count[static_cast<std::size_t>(axis)] = cells + 1;
    const double slack = cells - bounds.size()[axis] / spacing - 2 * margin;
    const double part = shift[axis] - std::floor(shift[axis]);
    lattice.origin[axis] =
        bounds.low[axis] - spacing * (margin + std::floor(0.5 * slack) + part * std::min(1.0, slack));
  }
  return lattice;
}

Lattice halved(const Lattice& lattice) {
  Lattice fine = lattice;
  fine.spacing = 0.5 * lattice.spacing;
  for (int& count : fine.count) count = 2 * count - 1;
  fine.unit_bits = lattice.unit_bits - 1;
  return fine;
}

Lattice doubled(const Lattice& lattice) {
  Lattice coarse = lattice;
  coarse.spacing = 2 * lattice.spacing;
  for (int& count : coarse.count) count = (count + 1) / 2;
  coarse.unit_bits = lattice.unit_bits + 1;
  return coarse;
}

SnappedSurfaces snapped(const DiffusionSurfaces& surfaces, const Lattice& lattice) {
  SnappedSurfaces result{&surfaces, {}};
  result.position.reserve(surfaces.vertex_count());
  for (const glm::vec3& p : surfaces.position) {
    std::array<std::int64_t, 3> units{};
    for (int axis = 0; axis < 3; ++axis) {
      const double exact = (static_cast<double>(p[axis]) - lattice.origin[axis]) / lattice.unit();
      units[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(exact + 0.5));
    }
    result.position.push_back(units);
  }
  return result;
}

}  // namespace pomona
