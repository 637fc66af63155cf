// How hard a bend presses on what lies on its inner side.
#pragma once

#include "generator/template/template.h"

namespace pomona {

struct BendStrain {
  double pressing = 0;  ///< radius over the axis's radius of curvature, at most; at 1 space would fold
  double lean = 0;      ///< of the axis from upright, at most; radians
};

/// Of the fruit's `bend`, for its widest surface at every height, in its proportions. Proportional to the bend.
BendStrain bend_strain(const Template& fruit);

/// What is bearable: where no more presses, no two points of the fruit come to the same place.
constexpr BendStrain most_strain{0.8, 1.309};  // 75 degrees

}  // namespace pomona
