// Grains that fill a volume: their sizes, and how they lie in it.
#pragma once

#include <vector>

#include "generator/template/ramp.h"

namespace pomona {

/// Grains of many sizes inside a closed surface: bubbles of bread, fat of a sausage, holes of cheese. As many grains
/// are this large or larger as a power law says. Their number follows from the drawn vertical curve, so all variants
/// have as many.
struct GrainVolume {
  enum class Heading { any, along, out, up, around };

  double from = 0.001, to = 0.01;  ///< sizes of the smallest and the largest, metres
  double exponent = 2.5;  ///< number of grains in a narrow range of sizes: proportional to size to the minus this
  double share = 0.1;     ///< volume of the grains over that of the solid of revolution of the vertical curve
  Ramp<double> near_skin = Ramp<double>::constant(1);  ///< the largest at this depth below the surface, metres, as a
                                                       ///< share of `to`
  Heading heading = Heading::any;                      ///< of their length: along the axis, away from it, up, around it
  double stray = 0;                                    ///< standard deviation of the heading, radians
  double wall = 0;                                     ///< least distance from the surface, metres
  double apart = 0;             ///< least distance from each other and from grains written before, metres
  double lumps = 0;             ///< how deep dents go, as a share of the radius
  std::vector<int> clear_of{};  ///< closed surfaces outside of which they stay
};

}  // namespace pomona
