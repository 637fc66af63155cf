// A section as pixels: what the drawing shows under its curves while they are dragged.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/diffusion/diffuser.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A rectangle in space, to be looked at: its corner at the top left, and its sides.
struct PictureFrame {
  glm::dvec3 corner{0}, right{1, 0, 0}, down{0, -1, 0};  ///< metres
  int width = 1, height = 1;                             ///< pixels
};

/// Red, green, blue (sRGB) and how much of the pixel lies inside, row by row from above. Inside is where the boundary
/// to air winds around: counted along rows, so that no triangulation is needed.
std::vector<std::uint8_t> plane_picture(const DiffusionSurfaces& surfaces, const ColorField& field,
                                        const PictureFrame& frame);

}  // namespace pomona
