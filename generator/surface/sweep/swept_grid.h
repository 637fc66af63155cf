// The swept grid of one sketch, before colours: vertices with their positions on the drawn curves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/surface/sweep/sweep_options.h"
#include "generator/template/template.h"

namespace pomona {

/// An azimuth, radians, as a share of the whole turn, [0, 1).
double turn_of(double azimuth);

/// A count of vertices at this detail, at least `min`.
int refined(int count, double detail, int min);

/// Rings of vertices along the vertical curve, with a single vertex where a ring has shrunk to a point:
/// id = 1 + (j - 1) n + i between two poles. A pure function of the counts, so all variants share it.
struct SweptGrid {
  std::vector<glm::dvec3> position;
  std::vector<double> along;   ///< share of the vertical curve
  std::vector<double> around;  ///< share of the horizontal curve, or of the fold; 0 at poles, never NaN
  std::vector<std::uint8_t> is_pole;
  std::vector<int> fold;      ///< the fold that begins or goes on here, from 0; 0 where there are none, and at poles
                              ///< around the axis
  std::vector<double> depth;  ///< in folds: 0 on the vertical curve's inner arc, 1 on its outer one; else 1
  std::vector<std::optional<double>> turn;  ///< azimuth as a share of the whole turn; nothing on the axis. May be
                                            ///< empty where it does not matter: in grains
  /// By the cells of either side (Side::cells): 0 in the middle of a cell, 1 on its border; empty where there are none.
  std::vector<double> front_cell = {}, back_cell = {};
  int folds_around = 1;              ///< number of folds around the axis in this grid
  std::vector<glm::uvec3> triangle;  ///< front outside
};

/// How the rings of a grid are connected.
struct GridShape {
  int around = 0;
  int rings = 0;  ///< poles included
  bool starts_in_pole = false;
  bool ends_in_pole = false;
  bool closed_along = false;  ///< the last ring is followed by the first
};

/// Triangles for vertices that run around, then along upwards; front away from the axis.
std::vector<glm::uvec3> grid_triangles(const GridShape& shape);

SweptGrid swept_around_axis(const Template& fruit, const SurfaceSketch& sketch, int around, int along);
std::vector<SweptGrid> swept_in_folds(const Template& fruit, const SurfaceSketch& sketch, int around, int along);

/// Throws the Error for a surface that cannot be swept.
[[noreturn]] void refuse(const Template& fruit, const SurfaceSketch& sketch, const std::string& why,
                         const std::string& hint);

}  // namespace pomona
