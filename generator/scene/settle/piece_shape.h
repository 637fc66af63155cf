// The shape of a solid as the physics needs it. It is made once, however often the solid is placed.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/distance_grid.h"
#include "generator/scene/settle/surface_samples.h"

namespace pomona {

/// Lengths are in metres; positions are relative to the centre of mass. The main material has density 1.
struct PieceShape {
  glm::dvec3 center{0};  ///< centre of mass, in the solid's frame
  double mass = 0;
  glm::dmat3 inverse_inertia{1};
  double size = 0;       ///< diagonal of the box
  double radius = 0;     ///< radius of the ball around the centre of mass
  double thickness = 0;  ///< twice the volume divided by the area; for a plate, its thickness
  glm::dvec3 up{0};      ///< normal of the largest cut face, a flat one if there is any; zero if there is none
  Box<float> box;
  DistanceGrid distance;
  SurfaceSamples samples;
};

/// The diagonal of a solid's box, metres.
double size_of(const Solid& solid);

/// \param unit mean size of the pieces, metres: it sets the density of samples on a much larger solid.
/// \param cells number of cells of the distance grid, about.
PieceShape piece_shape(const Solid& solid, double unit, int cells = 40000);

}  // namespace pomona
