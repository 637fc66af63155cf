// How the axis of a fruit is bent: cucumbers, peppers and okra are not straight.
#pragma once

namespace pomona {

/// A plane curve that the axis becomes. From the bottom (place -1) to the top (place 1) it turns by `angle`; of that
/// the upper half turns by (angle + swing) / 2 and the lower half by (angle - swing) / 2. Its curvature is linear in
/// the place: swing 0 is an arc of a circle, a large swing an S. On average it runs upwards.
struct AxisBend {
  double angle = 0;      ///< radians
  double swing = 0;      ///< radians
  double direction = 0;  ///< the azimuth towards which both ends turn, radians

  bool is_straight() const { return angle == 0 && swing == 0; }

  /// By how much the axis leans towards the direction, radians; 0 on average.
  double lean(double place) const;

  /// The lean's change per unit of place.
  double turning(double place) const;
};

}  // namespace pomona
