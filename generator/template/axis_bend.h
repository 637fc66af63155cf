// The bend of a fruit's axis: cucumbers, peppers and okra are not straight.
#pragma once

namespace pomona {

/// The axis becomes a plane curve. From the bottom (place -1) to the top (place 1) it turns by `angle`: the upper half
/// by (angle + swing) / 2, the lower half by (angle - swing) / 2. The curvature is a linear function of the place:
/// swing 0 gives an arc of a circle, a large swing an S. On average the curve runs upwards.
struct AxisBend {
  double angle = 0;      ///< radians
  double swing = 0;      ///< radians
  double direction = 0;  ///< the azimuth towards which both ends turn, radians

  bool is_straight() const { return angle == 0 && swing == 0; }

  /// The lean of the axis towards `direction`, radians; 0 on average.
  double lean(double place) const;

  /// The derivative of the lean with respect to the place.
  double turning(double place) const;
};

}  // namespace pomona
