// Options of a cut.
#pragma once

#include <span>

#include "generator/base/parallel.h"

namespace pomona {

/// How finely the section is triangulated. Lengths are shares of the fruit's bounding-box diagonal.
struct CutOptions {
  double coarsest = 1.0 / 40;   ///< longest edge, far from all surfaces
  double finest = 1.0 / 400;    ///< edges next to the finest surfaces are not made shorter than this
  double grading = 0.35;        ///< growth of edges per length of distance from cut segments
  double contrast = 18 / 255.;  ///< difference of colours between two surfaces that needs no vertices between them
  double crumb = 1e-6;          ///< share of the whole's volume below which a piece is a crumb
  Threads threads{};            ///< the result does not depend on them

  /// Parts of the fruit that knives leave whole (spared.h), ascending; slice() takes them from the template. They must
  /// outlive the cut. The section goes through them all the same.
  std::span<const int> spared_parts{};
  /// Parts of which pieces that are cut loose stay with what they lie against (stray_bits.h); likewise.
  std::span<const int> held_parts{};
};

/// Coarser than for a single fruit: a piece in a heap covers a tenth of the picture.
constexpr CutOptions coarse_cut{.coarsest = 1.0 / 30, .finest = 1.0 / 250, .grading = 0.4, .contrast = 60 / 255.};

/// Whether two sets of options give the same cut.
constexpr bool same_cut(const CutOptions& a, const CutOptions& b) {
  return a.coarsest == b.coarsest && a.finest == b.finest && a.grading == b.grading && a.contrast == b.contrast &&
         a.crumb == b.crumb;
}

}  // namespace pomona
