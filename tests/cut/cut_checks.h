// What tests of cutting ask of every cut, and fruits they cut.
#pragma once

#include <vector>

#include "generator/cut/cut.h"

namespace pomona::shapes {

/// Of all pieces, cubic metres.
double volume_of(const Cut& cut);

/// Every piece is closed, and together they are as large as the whole.
void expect_whole(const Cut& cut, double whole_volume);

/// To the bit, sections and pieces.
void expect_same(const Cut& first, const Cut& second);

/// A ball, a ring, a box with faces in planes, nested balls, a hollow ball, two rings through each other.
std::vector<DiffusionSurfaces> fruits_to_cut();

}  // namespace pomona::shapes
