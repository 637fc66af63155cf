// What is painted on one side of a surface.
#pragma once

#include "generator/base/color.h"
#include "generator/template/ramp.h"

namespace pomona {

/// The colour of one side: `along` the vertical curve (0 = where it starts: bottom) times `around` the
/// horizontal one (0 = its start; white where nothing is said; repeated in every fold of an N-fold fruit).
struct PaintedColor {
  Ramp<Color> along;
  Ramp<Color> around = Ramp<Color>::constant(Color(1.0f));
};

/// One side of a surface. `part` indexes Template::parts. Hidden: the side faces air.
struct Side {
  int part = 0;
  PaintedColor color;
  bool hidden = false;
};

}  // namespace pomona
