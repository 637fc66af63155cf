#include "generator/surface/grains/grain_colors.h"

#include <algorithm>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

constexpr std::uint64_t lightness_draw = 4, hue_draw = 5;  // those before belong to the pose

bool in_gamut(const Color& color) {
  return std::min({color.r, color.g, color.b}) >= 0 && std::max({color.r, color.g, color.b}) <= 1;
}

}  // namespace

GrainTint drawn_tint(const GrainSketch& sketch, std::uint64_t number, const GrainDraws& draws) {
  const std::uint64_t first = draws_per_candidate * number;
  return {sketch.lightness_jitter * (2 * draws.looks.uniform(first + lightness_draw) - 1),
          sketch.hue_jitter * (2 * draws.looks.uniform(first + hue_draw) - 1)};
}

Color tinted(const Color& color, const GrainTint& tint) {
  if (tint.lightness == 0 && tint.hue == 0) return color;
  const glm::vec3 lab = to_oklab(color);
  const double c = reproducible::cos(tint.hue), s = reproducible::sin(tint.hue);
  const auto lightness = static_cast<float>(std::clamp(lab.x + tint.lightness, 0.0, 1.0));
  const auto a = static_cast<float>(c * lab.y - s * lab.z), b = static_cast<float>(s * lab.y + c * lab.z);

  // Greys are in the gamut: as much chroma as there is room for, to 1/4096.
  const auto with_chroma = [&](float share) { return from_oklab({lightness, a * share, b * share}); };
  if (const Color full = with_chroma(1); in_gamut(full)) return full;
  float fits = 0;
  for (float step = 0.5f; step >= 1.0f / 4096; step /= 2) {
    if (in_gamut(with_chroma(fits + step))) fits += step;
  }
  return from_oklab_within_gamut({lightness, a * fits, b * fits});
}

}  // namespace pomona
