// Colours that differ from grain to grain.
#pragma once

#include "generator/base/color.h"
#include "generator/surface/sweep/grain_pose.h"

namespace pomona {

/// How one grain's colours differ from its sketch's.
struct GrainTint {
  double lightness = 0;  ///< added in OKLab
  double hue = 0;        ///< radians, a turn about OKLab's grey axis
};

GrainTint drawn_tint(const GrainSketch& sketch, std::uint64_t number, const GrainDraws& draws);

/// The colour with the tint; beyond the gamut its chroma shrinks until it fits. Colours without a tint stay as they
/// are, bit for bit.
Color tinted(const Color& color, const GrainTint& tint);

}  // namespace pomona
