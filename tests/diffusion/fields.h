// Colours painted onto surfaces by a formula, and the errors of results.
#pragma once

#include <functional>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona::fields {

using Field = std::function<glm::dvec3(const glm::dvec3&)>;

/// Both sides of every vertex take the field's value there.
DiffusionSurfaces painted_with(DiffusionSurfaces surfaces, const Field& field);

/// A linear field whose values are floats without rounding wherever coordinates are multiples of 1/1024 below 1.
glm::dvec3 dyadic_linear(const glm::dvec3& p);

/// A closed box of side 2 with coordinates that are multiples of 1/8 and, within it, two occluders: a closed
/// box and an open sheet, all painted with the dyadic linear field.
DiffusionSurfaces linear_scene();

/// Generic points inside the linear scene, outside its occluders.
std::vector<glm::vec3> points_in_linear_scene();

/// In channels times 255: root mean square over all channels; 95th percentile and maximum over points of the
/// worst channel.
struct Errors {
  double rms = 0, p95 = 0, max = 0;
};
Errors errors_of(const std::vector<Color>& colors, const std::vector<Color>& truth);

}  // namespace pomona::fields
