// Colour variation from grain to grain.
#pragma once

#include "generator/base/color.h"
#include "generator/surface/sweep/grain_pose.h"

namespace pomona {

/// The difference of one grain's colours from those of its sketch.
struct GrainTint {
  double lightness = 0;  ///< added in OKLab
  double hue = 0;        ///< radians, a turn about OKLab's grey axis
};

GrainTint drawn_tint(const GrainSketch& sketch, std::uint64_t number, const GrainDraws& draws);

/// The colour with the tint. Outside the gamut, its chroma is reduced until it fits. Without a tint the colour keeps
/// its bits.
Color tinted(const Color& color, const GrainTint& tint);

}  // namespace pomona
