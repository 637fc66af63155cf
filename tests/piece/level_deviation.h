// The deviation of a level of detail from its solid.
#pragma once

#include "generator/piece/solid.h"

namespace pomona {

struct LevelDeviation {
  double distance = 0;   ///< metres; the largest found, from either to the other
  double color_rms = 0;  ///< 0..255, sRGB, all channels; of the level's colours against the solid's, by area
};

/// Cut faces and surfaces are compared one by one, so a border that moved counts with the whole way that it moved. A
/// triangle of the level is compared only with triangles that face its way, so one that turned over is far from all.
/// Points are taken at the vertices and middles of the solid's triangles, and about `spacing` metres apart on the
/// level's.
LevelDeviation deviation(const Solid& level, const Solid& solid, double spacing);

}  // namespace pomona
