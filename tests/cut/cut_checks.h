// Expectations of every cut, and fruits to cut.
#pragma once

#include <vector>

#include "generator/cut/cut.h"

namespace pomona::shapes {

/// The volume of all pieces, cubic metres.
double volume_of(const Cut& cut);

/// Expects that every piece is closed, and that their volumes add up to the whole.
void expect_whole(const Cut& cut, double whole_volume);

/// Expects the same sections and pieces, to the bit.
void expect_same(const Cut& first, const Cut& second);

/// A ball, a ring, a box with faces in planes, nested balls, a hollow ball, two rings through each other.
std::vector<DiffusionSurfaces> fruits_to_cut();

}  // namespace pomona::shapes
