// The seats of a law: places by rule, where dart throwing finds them by chance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/surface/sweep/dart_throwing.h"
#include "generator/template/law_sketch.h"

namespace pomona {

/// A seat on the drawn curves.
struct LawSeat {
  double along = 0;    ///< share of the vertical curve
  double azimuth = 0;  ///< radians
  double spacing = 0;  ///< metres: the distance to its neighbours
};

/// The number of seats, or a few more, however many; to be asked before the seats are.
double law_room(const LawSketch& law, const Curve& vertical);

/// The seats on a surface around the axis with this vertical curve, from its lower end to the upper one. How many they
/// are depends on the curve alone, where they are on the random shifts, too.
std::vector<LawSeat> law_seats(const LawSketch& law, const Curve& vertical, const RandomStream& random);

/// The random shifts of a law's seats in one variant.
RandomStream law_draws(const LawSketch& law, VariantKey key);

/// The seats of the sketch's law as darts on the swept grid, as many as its ground leaves, each with a grain's pose.
std::vector<Dart> seated_darts(const LawSketch& law, const Curve& vertical, const SweptGrid& grid,
                               const GrainSketch& sketch, const GrainDraws& draws, VariantKey key);

}  // namespace pomona
