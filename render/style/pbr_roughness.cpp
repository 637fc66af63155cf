#include "render/style/pbr_roughness.h"

#include <algorithm>

namespace pomona {

double pbr_roughness(const MaterialSketch& material, bool on_cut_face) {
  if (on_cut_face) {
    const double dry = std::max(0.0, 1 - material.wet), wet = std::max(0.0, material.wet - 1);
    return std::max(0.25, pbr_dull + 0.3 * dry - 0.25 * wet);
  }
  const double smoothness = std::max(0.0, 0.3 - material.roughness);
  return pbr_dull + (material.roughness > 0.3 ? 0.57 * (material.roughness - 0.3) : -0.8 * smoothness);
}

double pbr_film(const MaterialSketch& material) {
  if (material.coat) return *material.coat;
  return std::min(0.8, 0.5 * std::max(0.0, material.wet - 1));
}

}  // namespace pomona
