// The change of a fruit's colours as it ripens.
#pragma once

#include <vector>

#include "generator/base/color.h"
#include "generator/template/ramp.h"

namespace pomona {

/// Ripeness r: 0 = unripe, 1 = as drawn, 2 = overripe. It does not come everywhere at once: each place has a
/// lateness l = height + depth + patches + the part's own `late`, kept within 0..1, and its own ripeness
///   x = 1 - clamp(u (1 + s) - s (1 - l), 0, 1) with u = 1 - r, where r < 1,
///   x = 1 + clamp(v (1 + s) - s l, 0, 1)       with v = r - 1, where r > 1,
/// s being `spread`: late places are green longest and spoil last. x never falls as r grows.
struct RipenessSketch {
  /// One part's colours at their own ripeness: piecewise linear in OKLab between `stops` and, at 1, the drawn
  /// colour; constant outside. A stop moves with the drawn colour: it stands for the part's mean drawn colour,
  /// and a share `keep` of what a place differs from that mean stays.
  struct Part {
    int part = 0;  ///< index into Template::parts
    std::vector<Ramp<Color>::Stop> stops;
    double keep = 0.3;
    double late = 0;  ///< -1..1
  };
  std::vector<Part> parts;
  double spread = 1;                                ///< 0 = everywhere at once
  Ramp<double> height = Ramp<double>::constant(0);  ///< lateness from the bottom of the skin, 0, to its top, 1
  Ramp<double> depth = Ramp<double>::constant(0);   ///< lateness by the depth below the skin, metres
  double patches = 0;                               ///< lateness that smooth noise adds or takes away
  double patch_size = 0.01;                         ///< metres

  bool declared() const { return !parts.empty(); }
};

}  // namespace pomona
