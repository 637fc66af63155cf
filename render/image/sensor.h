// What a camera does to light: exposure, a lens that is not quite sharp, and noise.
#pragma once

#include "generator/base/random.h"
#include "render/image/image.h"

namespace pomona {

struct SensorOptions {
  double exposure = 0;  ///< stops: 1 = twice the light
  double blur = 0;      ///< standard deviation of a Gaussian, pixels
  double noise = 0;     ///< standard deviation of the noise of white, 1 = the range from black to white
  VariantKey key = {};  ///< of the noise
};

/// The picture as such a camera takes it. All of it happens in linear light. Most noise is that of light itself, whose
/// variance grows with it; a fifth of white's variance is there in the dark, too.
Image sensed(const Image& picture, const SensorOptions& options);

}  // namespace pomona
