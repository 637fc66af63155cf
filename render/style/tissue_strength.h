// How much tissue holds before it tears.
#pragma once

#include "generator/template/material_sketch.h"

namespace pomona {

/// Pascals, pulled at right angles to the tear. Assumed orders of magnitude, not measurements: flesh tears at some
/// tenths of a megapascal, gel at a hundredth of that, skins and shells at some ten times as much.
double tissue_strength(Tissue tissue);

}  // namespace pomona
