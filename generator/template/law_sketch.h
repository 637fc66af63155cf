// Laws by which organs sit: on a surface in spirals, lattices, rows, whorls; or in clusters around the axis.
#pragma once

#include <string>

#include "generator/base/curve.h"
#include "generator/template/ramp.h"

namespace pomona {

/// Seats on a surface around the axis, from its lower end to its upper one. They are counted on the drawn vertical
/// curve, where they are at home as a share of it and an azimuth; so all variants have as many, at the same places.
struct LawSketch {
  enum class Kind {
    spiral,        ///< one after another, each `divergence` further around, as much area to each as `spacing` asks for
    parastichies,  ///< the same on the lattice whose two families of spirals number `pair`: seats grow with the girth
    rows,          ///< `count` rows from bottom to top
    whorls,        ///< rings of `count`, each `turn` further around
    cluster,       ///< `spacing` apart in the room within `envelope`: berries of a bunch
  };
  std::string name;
  Kind kind = Kind::spiral;
  Ramp<double> spacing = Ramp<double>::constant(0.005);  ///< metres, by the share of the vertical curve
  double divergence = 2.39996322972865332;               ///< radians; by default the golden angle
  int low_pair = 8, high_pair = 13;                      ///< of parastichies
  int count = 1;                                         ///< rows, or seats of a whorl
  double stagger = 0.5;     ///< of rows: how far every second one is shifted, as a share of the spacing
  double twist = 0;         ///< of rows: how far they turn from the lower end of the band to the upper, radians
  double turn = 0;          ///< of whorls, radians
  double start = 0;         ///< azimuth of the first seat, radians
  double from = 0, to = 1;  ///< the stretch of the vertical curve, as shares
  double jitter = 0;        ///< random shift to every side, as a share of the spacing
  Curve envelope;           ///< of clusters: a vertical curve around their seats
  double hollow = 0;        ///< of clusters: no seat is nearer to the axis, metres
};

/// How far an angle is from the nearest whole turn, radians, -pi..pi.
double beside_whole_turns(double angle);

}  // namespace pomona
