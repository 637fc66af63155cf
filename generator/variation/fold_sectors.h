// Where chambers lie around the axis: how deep within one a half-plane from the axis runs.
#pragma once

#include <vector>

#include "generator/template/template.h"

namespace pomona {

/// The range of azimuths that a loop covers, radians.
struct Sector {
  double middle = 0, half_width = 0;
};

using Sectors = std::vector<Sector>;

/// The sectors between fold lines.
Sectors sectors_between_folds(const FoldSymmetry& symmetry);

/// The distance of an azimuth from the edge of its sector, radians; negative outside all sectors. Half of the distance
/// from the edge to the middle is deep enough: often there are no seeds in the very middle.
double depth_at(const Sectors& sectors, double azimuth);

}  // namespace pomona
