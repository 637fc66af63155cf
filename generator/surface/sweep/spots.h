// Spots and patches on a swept surface.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/random.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

/// A spot where it lies.
struct Spot {
  glm::dvec3 center{0};
  glm::dvec3 normal{0, 1, 0};   ///< unit, of the front, whichever side it is on
  glm::dvec3 tangent{1, 0, 0};  ///< unit, along the vertical curve
  double radius = 0;            ///< metres, across the curve
  double stretch = 1, softness = 0, strength = 1;
  std::array<glm::dvec2, 4> waves{};  ///< of the outline, 2 to 5 around it; their lengths add up to the raggedness
  Color color{0};
};

/// All spots of one side of a surface, in the order in which they are painted. Scattered ones lie by the key:
/// the same for (seed, index), elsewhere in other variants.
/// \throws Error (bad_data) for more than 20 000 of one kind, or so many large ones that painting them would take long.
std::vector<Spot> placed_spots(const Template& fruit, const SurfaceSketch& sketch, SideOf side,
                               std::span<const SweptGrid> grids, VariantKey key);

/// The share of a spot at a point of the surface, 0..1; `normal` is the front's there, unit.
/// Distance is the chord's, longer where the surface turns away from the spot: chord / ((1 + cos turned) / 2)^(1/4),
/// which is within 7 % of the way over a sphere up to a right angle, and never reaches through a thin wall.
double cover_of(const Spot& spot, const glm::dvec3& point, const glm::dvec3& normal);

/// The colours of a grid's vertices with the spots over them, each a blend of its ground and spot colour.
std::vector<Color> with_spots(const SweptGrid& grid, std::vector<Color> ground, std::span<const Spot> spots);

/// One line for every kind of spots whose least width is below the widest cell of the surface where they lie: some of
/// them may fall between the vertices and be lost.
std::vector<std::string> spot_warnings(const Template& fruit, const SweepOptions& options = {});

}  // namespace pomona
