// Pictures of all directions around a place, which light what stands in it.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "render/image/image.h"
#include "render/image/linear_pixels.h"

namespace pomona {

/// The light of an environment as one lamp and equal light from all sides. Angles are radians.
struct EnvironmentLight {
  double azimuth = 0;    ///< of the lamp, from +Z towards +X
  double elevation = 0;  ///< above the table
  double softness = 0;   ///< 0 = the lamp is a point, 1 = half the sky
  double strength = 1;  ///< of the lamp, times the usual, at an exposure that shows white paper as the usual light does
  double ambient = 1;   ///< light from all sides, times the usual
  Color tint{1};        ///< the colour of all light on a table, as bright as white
};

/// A .png, or an .hdr, whose numbers are exposed so that white paper on the table is white.
/// Environments are equirectangular, as cameras of 360 degrees write them: the middle row is the horizon, the middle
/// column lies towards -Z, and +X to the right of it.
/// \param name for messages. \throws Error (bad_data) for a picture that is not twice as wide as high.
LinearImage read_environment(const std::string& bytes, const std::string& name);

/// \param picture of read_environment(). What is below the horizon lights nothing.
EnvironmentLight light_of(const LinearImage& picture);

/// Axes of a camera that looks along -back, unit.
struct CameraAxes {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
};

/// What such a camera sees of the environment, which is far away. \param vertical_field radians
Image seen_around(const LinearImage& picture, const CameraAxes& camera, double vertical_field, int width, int height);

}  // namespace pomona
