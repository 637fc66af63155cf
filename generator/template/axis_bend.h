// The axis of a fruit that is not straight: cucumbers, peppers and okra bend a little, bananas much.
#pragma once

#include <vector>

#include "generator/template/ramp.h"

namespace pomona {

/// The axis becomes a plane curve, about which sections may turn. Places run from the bottom (-1) to the top (1).
///
/// A drawn axis leans as its `line` does. On top of that it turns by `angle` from the bottom to the top: the upper half
/// by (angle + swing) / 2, the lower half by (angle - swing) / 2. The curvature of that is a linear function of the
/// place: swing 0 gives an arc of a circle, a large swing an S; its mean lean is 0, so that without a line the axis
/// runs upwards on average.
struct AxisBend {
  double angle = 0;               ///< radians
  double swing = 0;               ///< radians
  double direction = 0;           ///< the azimuth of the plane: both ends turn towards it, radians
  std::vector<double> line = {};  ///< lean of the drawn axis at evenly spaced places, radians; none = straight upwards
  Ramp<double> twist = Ramp<double>::constant(0);  ///< turn of the sections about the axis, against the clock as seen
                                                   ///< from above, radians; by the share of the height, 0 to 1

  bool leans() const { return angle != 0 || swing != 0 || !line.empty(); }
  bool twists() const;
  bool is_straight() const { return !leans() && !twists(); }

  /// The lean of the axis towards `direction`, radians.
  double lean(double place) const;

  /// The derivative of the lean with respect to the place.
  double turning(double place) const;

  /// The largest turning, whichever way, between two places.
  double largest_turning(double from, double to) const;

  /// Line and twist as drawn, without the bend of an individual.
  AxisBend as_line() const;
};

}  // namespace pomona
