// The paint on one side of a surface.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "generator/base/color.h"
#include "generator/template/cell_sketch.h"
#include "generator/template/ramp.h"
#include "generator/template/spot_sketch.h"

namespace pomona {

// Places in the ramps below. Along: the vertical curve, 0 = where it starts (bottom), 1 = its end. Around: the
// horizontal curve, 0 = its start; once in every fold of an N-fold fruit. Turn: the azimuth as a share of the whole
// turn, 0 and 1 = +X. A pole takes the mean of each ramp that has no place there. On a fold line two folds meet,
// and the values of both count half.

/// The ground colour of one side: the product of what is said along, around, over the turn and fold by fold.
/// As no factor is above white, painting so only darkens; coats and spots brighten.
struct PaintedColor {
  Ramp<Color> along;
  Ramp<Color> around = Ramp<Color>::constant(Color(1.0f));
  Ramp<Color> turn = Ramp<Color>::constant(Color(1.0f));
  std::vector<Color> folds = {};  ///< taken in turn; none = white
};

/// A coat of paint over the ground: it covers the product of these shares, each 0..1.
struct Coat {
  Ramp<Color> color;  ///< along
  Ramp<double> along = Ramp<double>::constant(1);
  Ramp<double> around = Ramp<double>::constant(1);
  Ramp<double> turn = Ramp<double>::constant(1);
  std::vector<double> folds = {};  ///< taken in turn; none = 1
};

/// Half the width of the passage between the two sides' colours, metres: `along` times two shares, each 0..1.
struct PaintedBlur {
  PaintedBlur() = default;
  PaintedBlur(Ramp<double> metres_along) : along(std::move(metres_along)) {}
  Ramp<double> along = Ramp<double>::constant(0);
  Ramp<double> around = Ramp<double>::constant(1);
  Ramp<double> turn = Ramp<double>::constant(1);
};

/// One side of a surface. `part` indexes Template::parts. Hidden: the side faces air.
/// Coats lie over the ground in their order, cells over the coats, spots over the cells.
struct Side {
  int part = 0;
  PaintedColor color;
  bool hidden = false;
  std::vector<Coat> coats = {};
  std::optional<CellSketch> cells = {};
  std::vector<SpotSketch> spots = {};
};

}  // namespace pomona
