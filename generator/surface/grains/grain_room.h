// Room for grains between walls: no grain straddles one.
#pragma once

#include <span>
#include <vector>

#include "generator/surface/grains/grain_walls.h"
#include "generator/surface/sweep/dart_throwing.h"

namespace pomona {

/// The darts, each so moved that its grain keeps clear of the walls, on that side on which it was sown. What finds no
/// room shrinks, to six tenths at most; what finds none then, or only in another grain, is left out. Darts that are
/// clear keep their bits. \param others darts of other kinds, which also take room.
std::vector<Dart> with_room(std::vector<Dart> darts, const GrainSketch& sketch, const GrainWalls& walls,
                            std::span<const Dart> others);

}  // namespace pomona
