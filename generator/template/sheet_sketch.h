// Sheets of a template: leaves that wrap each other, plates that hang side by side, rolls and stacks.
#pragma once

#include <string>
#include <vector>

#include "generator/base/curve.h"
#include "generator/template/ramp.h"
#include "generator/template/side.h"

namespace pomona {

/// A ridge along the middle of a leaf, on its outside.
struct SheetRib {
  double width = 0.1;                               ///< of the ground's radius: how far from the middle it fades
  Ramp<double> height = Ramp<double>::constant(0);  ///< metres, along the leaf
};

/// Waves along the two margins of a leaf.
struct SheetRuffle {
  double height = 0;  ///< metres
  int waves = 4;      ///< on the length of a leaf
};

/// Paler lines from the middle of a leaf to its margins.
struct SheetVeins {
  Color color{1.0f};
  int pairs = 0;
  double strength = 0;  ///< how much of the leaf's colour they cover, 0..1
};

/// The place where the leaves of a rosette end at the latest: beyond 1 they would lie over each other on the axis.
constexpr double rosette_end = 0.97;

/// Many thin bodies of one kind, one over the other or side by side. Each is a closed shell of a front, which faces
/// air, and a flesh behind it. They meet nowhere.
struct SheetSketch {
  enum class Kind {
    head,     ///< leaves that wrap each other over the end of the axis
    rosette,  ///< leaves that end before it
    blades,   ///< plates in half-planes through the axis
    roll,     ///< sheets wound around the axis
    stack,    ///< layers over each other
  };
  std::string name;
  Kind kind = Kind::head;
  int count = 1;       ///< 0: they are left out
  Curve inner, outer;  ///< side view, open: where the first leaf lies and the last one, from the base to the tip; of
                       ///< blades their two edges, from the axis outwards; of a roll its innermost turn and its
                       ///< outermost; of a stack its underside and its top, from the axis outwards
  double divergence = 2.39996322972865332;  ///< radians from leaf to leaf; by default the golden angle
  double turn_jitter = 0;                   ///< standard deviation of a leaf's azimuth, radians

  // Places along a leaf: 0 = its base, 1 = the end of the curves; leaves of a head go on beyond it, down the other
  // side. Ages: 0 = the first leaf, the innermost and youngest, 1 = the last.
  Ramp<double> outline = Ramp<double>::constant(0.6);     ///< half the width along, as a share of the ground's radius
  Ramp<double> reach = Ramp<double>::constant(1);         ///< by age: the place where a leaf ends
  double outline_jitter = 0, reach_jitter = 0;            ///< standard deviations, as shares
  Ramp<double> thickness = Ramp<double>::constant(1e-3);  ///< metres, along
  Ramp<double> by_age = Ramp<double>::constant(1);        ///< factor of the thickness
  SheetRib rib = {};
  SheetRuffle ruffle = {};
  double gap = 2e-4;     ///< between sheets, metres: the least
  double stand_off = 0;  ///< how far the tip of the last leaf stands off, metres; younger ones less

  std::vector<double> lengths = {1.0};  ///< blades: in turn, as a share of the curves, from their outer ends inwards
  double sway = 0;                      ///< blades and rolls: how far they wave to either side, metres
  double turns = 3;                     ///< rolls: how often each sheet goes around
  Curve loop;                           ///< stacks: the outline seen from above; empty: a circle
  double stray = 0;                     ///< stacks: standard deviation of how far a layer lies off the axis, metres

  Side front, back;  ///< `around` runs across the leaf, `turn` from the youngest to the oldest; in a roll `around` runs
                     ///< from its inner end to its outer one, in a stack around the axis
  SheetVeins veins = {};
  double blur = 0;  ///< metres
  int around = 40, along = 32;
};

}  // namespace pomona
