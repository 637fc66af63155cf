// Places for grains that fill a volume.
#pragma once

#include <vector>

#include "generator/surface/sweep/dart_throwing.h"
#include "generator/surface/sweep/sweep_options.h"
#include "generator/template/template.h"

namespace pomona {

/// The number of grains, however many; to be asked before the grains are. It depends on the drawn vertical curve alone.
double volume_room(const GrainSketch& sketch, const Curve& vertical);

/// The size of the grain of this number among `count`: that of its place in the power law, the largest first. Metres.
double volume_size(const GrainVolume& volume, std::size_t number, std::size_t count);

/// A grain placed before, in the ellipsoid that holds it.
struct GrainObstacle {
  glm::dvec3 center{0};
  GrainPose body;
};

/// The ellipsoid that holds a grain of this form.
GrainPose body_of(const GrainPose& pose, const GrainForm& form);

/// What is wrong with a volume in which the grains found no room.
struct NoRoom {
  double size = 0;  ///< metres: of the first that found none
};

/// One grain for each number: the largest first, each tries random places inside the surface until it meets neither
/// walls nor other grains. Where a volume is nearly full, a grain shrinks until it fits.
/// \throws NoRoom if one finds no place at a tenth of its size
std::vector<Dart> volume_darts(const Template& fruit, const GrainSketch& sketch, const GrainDraws& draws,
                               VariantKey key, const SweepOptions& options, const std::vector<GrainObstacle>& others);

}  // namespace pomona
