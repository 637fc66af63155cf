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

/// One patch at a place, or many spots: at the seats of a law, or scattered by the variant's key. Distances are taken
/// over the surface (see spots.h). What is smaller than the space between a surface's vertices is lost.
struct SpotSketch {
  Color color{0};
  std::optional<PatchPlace> place;            ///< a single patch; else:
  std::optional<int> law;                     ///< index into Template::laws; else scattered:
  double spacing = 0;                         ///< smallest distance of two centres that face the same way, metres
  int count = 0;                              ///< largest number; 0 = as many as there is room for
  double along_from = 0, along_to = 1;        ///< the band of the vertical curve where centres lie
  double size_min = 0.001, size_max = 0.001;  ///< width, metres: even draws between the two
  double stretch = 1;                         ///< length along the vertical curve over width
  double softness = 0.5;                      ///< share of its radius over which it fades out
  double raggedness = 0;                      ///< 0 = round, 0.9 = very uneven outline
  double strength = 1;                        ///< opacity in its middle
  double relief = 0;                          ///< height above the surface, metres, negative = below
};

}  // namespace pomona
