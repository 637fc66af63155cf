// The fine grain in the colours of a fruit.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// The largest number of a noise pattern. A fruit as drawn has pattern 0, variants others. Single precision must
/// represent these numbers together with all lattice indices.
constexpr std::uint32_t max_pattern = (1u << 24) - (1u << 13);

/// What graphics cards have room for.
constexpr int max_noise_keys = 16;
constexpr int max_noise_bands = 8;

/// Perlin modulation keyed by the unmodulated colour (paper, section 5; docs/reference/style.md).
struct NoiseKey {
  Color color;
  std::vector<double> weights;  ///< one per band, OKLab units
  glm::vec3 axis{1, 0, 0};      ///< OKLab direction of the modulation
};

struct NoiseStyle {
  double base_frequency = 0;    ///< cycles per metre of the lowest band; each further band doubles it
  glm::dvec3 stretch{1, 1, 1};  ///< frequencies times this along radius, height, azimuth: 1,1,1 = isotropic in x,y,z
  double sigma = 0.12;          ///< OKLab distance over which a key fades
  std::uint32_t pattern = 0;    ///< 0..max_pattern, set in variants
  std::vector<NoiseKey> keys;
};

}  // namespace pomona
