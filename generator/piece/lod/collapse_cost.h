// The cost of a collapse: quadrics of place [Garland & Heckbert 1997] and of colour [Hoppe 1999].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/piece/lod/level_mesh.h"

namespace pomona {

/// A quadratic function of a place: x'Ax + 2b'x + c.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, x = 0, y = 0, z = 0, c = 0;

  /// Weight times the square of normal . p + offset.
  static Quadric of_plane(const glm::dvec3& normal, double offset, double weight);

  Quadric& operator+=(const Quadric& q);
  double at(const glm::dvec3& p) const;
};

/// Colours as linear functions of place, triangle by triangle: the sum of the squared differences from them.
struct ColorQuadric {
  Quadric square;
  std::array<glm::dvec4, 3> mean{};  ///< per channel: gradients and offsets, by weight
  double weight = 0;                 ///< square metres

  ColorQuadric& operator+=(const ColorQuadric& q);
  double at(const glm::dvec3& p, const glm::dvec3& color) const;
};

/// Costs are areas times squared metres.
struct CollapseCosts {
  std::vector<Quadric> shape;          ///< per fan
  std::vector<double> shape_here;      ///< per fan: its shape, at its own place
  std::vector<ColorQuadric> tint;      ///< per vertex of the solid
  std::vector<std::uint32_t> tint_of;  ///< per vertex: whose tint is its own
  double metres_per_color = 0;
};

CollapseCosts collapse_costs(const LevelSource& source, const LevelMesh& level, double metres_per_color);

/// The cost of moving a vertex along a spoke of its ring. `on_border`: the spoke is part of its border.
double cost_of(const CollapseCosts& costs, const LevelSource& source, const LevelMesh& level, std::uint32_t fan,
               const Spoke& spoke, bool on_border);

/// Adds the quadrics of a removed fan, or of one of its vertices, to those of the kept one.
void take_over_shape(CollapseCosts& costs, const LevelSource& source, std::uint32_t from, std::uint32_t to);
void take_over_tint(CollapseCosts& costs, std::uint32_t from, std::uint32_t to);

}  // namespace pomona
