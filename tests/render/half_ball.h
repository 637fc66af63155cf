// Small solids for tests of baking.
#pragma once

#include "generator/piece/solid.h"

namespace pomona::named {

/// Half a ball of radius 1, y > 0, green outside, with a red cut face at y = 0 whose colour grows with x.
Solid half_ball(int around = 24, int up = 6);

/// A whole ball of skin.
Solid ball(int around, int up);

/// A cut face from (-1, 0, -0.5) to (1, 0, 0.5), seen from below, blue where x < 0 and red where x > 0, its vertices
/// doubled along x = 0.
Solid split_plate();

Solid without_cut_faces(const Solid& solid);

}  // namespace pomona::named
