// The cells of a law on one side of a surface: fused organs, such as a pineapple's eyes.
#pragma once

#include "generator/base/color.h"
#include "generator/template/ramp.h"

namespace pomona {

/// Each place of a surface around the axis lies in the cell of the seat nearest to it. With d1 and d2 the distances of
/// the two nearest seats, its place in the cell is 2 d1 / (d1 + d2): 0 in the middle, 1 on the border. The ramps are
/// over that place.
struct CellSketch {
  int law = 0;  ///< index into Template::laws
  Ramp<Color> color;
  Ramp<double> cover = Ramp<double>::constant(0);  ///< how far the colour covers what is below, 0..1
  Ramp<double> raise = Ramp<double>::constant(0);  ///< metres towards this side
  Ramp<double> along = Ramp<double>::constant(1);  ///< by the share of the vertical curve: factor of cover and raise
};

}  // namespace pomona
