// Checks whether the surfaces swept from a variant cross where those of the drawing do not.
#pragma once

#include <memory>
#include <vector>

#include "generator/surface/crossings.h"
#include "generator/template/template.h"

namespace pomona {

/// Curves that do not cross may still be swept into surfaces that cross, by the width of a facet. So this checks the
/// swept triangles, at detail 1: two surfaces may cross in a variant only if they cross in the drawing. The drawing is
/// tested only for pairs of surfaces that cross in some variant; the result is kept, and copies of this object share
/// it.
class SweptCheck {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit SweptCheck(const Template& drawn);

  /// The azimuths of the crossings that the drawing does not have, one for the middle of each triangle, radians. The
  /// bend of the axis is ignored in both.
  std::vector<double> new_crossings(const Template& variant) const;

  /// True if anything crosses that does not cross in the drawing. Both are bent as they are.
  bool crosses_anew(const Template& variant) const;

 private:
  class KnownCrossings;
  class Drawing;
  std::shared_ptr<const Drawing> drawing_;
};

}  // namespace pomona
