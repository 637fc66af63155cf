// The proportions of a variant, relative to the drawing.
#pragma once

namespace pomona {

/// A one-to-one map, the same in every half-plane through the axis: heights are mapped to heights, and radii are
/// multiplied by a factor that depends on the height. Curves that do not cross before do not cross after. Places run
/// from -1 at the bottom of the drawing to 1 at its top.
struct Proportions {
  double slenderness = 0;  ///< logarithm of height over width, at the same volume
  double pear = 0;         ///< logarithm of the width of the top relative to the middle; the bottom is the inverse
  double barrel = 0;       ///< logarithm of the width of the middle relative to the ends
  double shoulders = 0;    ///< logarithm of the width below the top relative to that above the bottom
  double stretch = 0;      ///< how much longer the lower half is than the upper one, as a share; -1 < stretch < 1

  bool are_as_drawn() const;

  /// The factor of the whole height.
  double height_factor() const;

  /// The place to which a place of the drawing is mapped.
  double place(double drawn) const;

  /// The factor of radii at a place of the drawing.
  double radius_factor(double drawn) const;
};

}  // namespace pomona
