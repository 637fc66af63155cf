// Whether what is swept from a variant crosses where the drawing does not.
#pragma once

#include <memory>
#include <vector>

#include "generator/surface/crossings.h"
#include "generator/template/template.h"

namespace pomona {

/// Curves that keep apart may still be swept into surfaces that cross, by a facet's width. Looks at the swept triangles
/// themselves, at detail 1: two surfaces may only cross in a variant if they do so in the drawing. What crosses there
/// is looked for between surfaces that have come to cross in a variant, and only until it is found. Copies share it.
class SweptCheck {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit SweptCheck(const Template& drawn);

  /// The azimuths of the crossings that the drawing does not have; one in the middle of each triangle. Bends are left
  /// out, in drawing and variant.
  std::vector<double> new_crossings(const Template& variant) const;

  /// True if anything crosses that does not in the drawing, bent as both are.
  bool crosses_anew(const Template& variant) const;

 private:
  class KnownCrossings;
  class Drawing;
  std::shared_ptr<const Drawing> drawing_;
};

}  // namespace pomona
