// The fine grain in the colours of a fruit.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// Perlin modulation keyed by the unmodulated colour (paper, section 5; docs/style.md).
struct NoiseKey {
  Color color;
  std::vector<double> weights;  ///< one per band, OKLab units
  glm::vec3 axis{1, 0, 0};      ///< OKLab direction of the modulation
};

struct NoiseStyle {
  double base_frequency = 0;    ///< cycles per metre of the lowest band; each further band doubles it
  glm::dvec3 stretch{1, 1, 1};  ///< frequencies times this along radius, height, azimuth: 1,1,1 = isotropic in x,y,z
  double sigma = 0.12;          ///< OKLab distance over which a key fades
  std::vector<NoiseKey> keys;
};

}  // namespace pomona
