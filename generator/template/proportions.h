// How the proportions of a variant differ from the drawing.
#pragma once

namespace pomona {

/// A one-to-one map of every half-plane through the axis, the same for all: heights go to heights, and radii are
/// multiplied by a factor that depends on the height. What does not cross before does not cross after. Places run from
/// -1 at the bottom of the drawing to 1 at its top.
struct Proportions {
  double slenderness = 0;  ///< logarithm of height over width, at the same volume
  double pear = 0;         ///< logarithm of how much wider the top is than the middle; the bottom is as much narrower
  double barrel = 0;       ///< ... the middle is than the ends
  double shoulders = 0;    ///< ... it is below the top than above the bottom
  double stretch = 0;      ///< by how much the lower half is longer than the upper one, a share; -1 < stretch < 1

  bool are_as_drawn() const;

  /// What heights are multiplied by on the whole.
  double height_factor() const;

  /// Where in the height a place comes to lie.
  double place(double drawn) const;

  /// What radii are multiplied by at a place of the drawing.
  double radius_factor(double drawn) const;
};

}  // namespace pomona
