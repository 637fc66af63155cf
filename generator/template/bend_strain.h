// The strain of a bend on its inner side.
#pragma once

#include "generator/template/template.h"

namespace pomona {

struct BendStrain {
  double pressing =
      0;            ///< largest compression: radius divided by the axis's radius of curvature; at 1 space would fold
  double lean = 0;  ///< largest angle between the axis and the vertical, radians; of a drawn axis: half of what all
                    ///< its directions span
};

/// The strain of the fruit's `bend`, for its widest surface at every height, with its proportions. Without a
/// drawn axis it is proportional to the bend.
BendStrain bend_strain(const Template& fruit);

/// The largest allowed strain: up to it, no two points of the fruit get the same position.
constexpr BendStrain max_strain{0.8, 1.309};  // 75 degrees

}  // namespace pomona
