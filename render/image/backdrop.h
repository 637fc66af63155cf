// What is drawn on white paper, before another picture or before nothing.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "render/image/image.h"

namespace pomona {

/// The share of each pixel that things cover, 0 to 1; the rest is paper, with the shadows and the ink on it.
using CoveredShares = std::vector<float>;

/// The picture with another one in place of its white paper, which takes the shadows. Both have the same size.
Image before(const Image& on_white, const CoveredShares& covered, const Image& backdrop);

/// The same before nothing: the paper is transparent but for its shadows.
TransparentImage before_nothing(const Image& on_white, const CoveredShares& covered);

/// A part of a picture in another size. \param at where the part lies, 0..1 of the room that is left each way. \param
/// share its size, of the largest part of this shape.
Image cropped(const Image& whole, int width, int height, const glm::dvec2& at, double share);

}  // namespace pomona
