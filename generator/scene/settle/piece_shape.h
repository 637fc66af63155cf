// What settling needs to know of a solid, made once however often it is placed.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/distance_grid.h"
#include "generator/scene/settle/surface_samples.h"

namespace pomona {

/// Lengths in metres, places about the centre of mass; the density of what parts do not differ from counts as 1.
struct PieceShape {
  glm::dvec3 center{0};  ///< of mass, in the solid's frame
  double mass = 0;
  glm::dmat3 inverse_inertia{1};
  double size = 0;       ///< diagonal of its box
  double radius = 0;     ///< of the ball around the centre of mass
  double thickness = 0;  ///< twice the volume per area: that of a plate
  glm::dvec3 up{0};      ///< where the largest cut face looks, a flat one if there is any; zero where there is none
  Box<float> box;
  DistanceGrid distance;
  SurfaceSamples samples;
};

/// The diagonal of a solid's box, metres.
double size_of(const Solid& solid);

/// \param unit the pieces' mean size: what is much larger is sampled as densely as these.
/// \param cells of its distance grid.
PieceShape piece_shape(const Solid& solid, double unit, int cells = 40000);

}  // namespace pomona
