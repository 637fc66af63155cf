// A section as pixels, shown under the curves of the drawing while they are dragged.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/diffusion/diffuser.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The rectangle in space that a picture shows: its top left corner and its sides.
struct PictureFrame {
  glm::dvec3 corner{0}, right{1, 0, 0}, down{0, -1, 0};  ///< metres
  int width = 1, height = 1;                             ///< pixels
};

/// Red, green, blue (sRGB) and the share of the pixel inside the fruit, row by row from the top. The winding of the
/// boundary to air, counted along rows, tells inside from outside, so no triangulation is needed.
std::vector<std::uint8_t> plane_picture(const DiffusionSurfaces& surfaces, const ColorField& field,
                                        const PictureFrame& frame);

}  // namespace pomona
