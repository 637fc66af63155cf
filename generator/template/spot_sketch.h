// Spots and patches painted on a surface.
#pragma once

#include <optional>

#include "generator/base/color.h"

namespace pomona {

/// The place of a single patch.
struct PatchPlace {
  double along = 0;    ///< share of the vertical curve
  double azimuth = 0;  ///< radians from +X towards -Z
};

/// One patch at a place, or many spots scattered by the variant's key. Distances are taken over the surface
/// (see spots.h). What is smaller than the space between a surface's vertices is lost.
struct SpotSketch {
  Color color{0};
  std::optional<PatchPlace> place;               ///< a single patch; else scattered:
  double spacing = 0;                            ///< metres: no two centres that face the same way are nearer
  int count = 0;                                 ///< no more than so many; 0 = as many as have room
  double along_from = 0, along_to = 1;           ///< the band of the vertical curve where centres lie
  double size_least = 0.001, size_most = 0.001;  ///< width, metres: even draws between the two
  double stretch = 1;                            ///< length along the vertical curve over width
  double softness = 0.5;                         ///< share of the way from the middle to the rim over which it fades
  double raggedness = 0;                         ///< 0 = round, 0.9 = an outline that wanders far in
  double strength = 1;                           ///< share it covers in its middle
  double relief = 0;                             ///< metres that it stands out, or is sunk where negative
};

}  // namespace pomona
