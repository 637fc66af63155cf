// Options of a sweep.
#pragma once

#include <algorithm>

#include "generator/base/parallel.h"
#include "generator/base/random.h"

namespace pomona {

struct SweepOptions {
  double detail = 1.0;   ///< multiplies the number of vertices around and along, 0.1..4
  VariantKey key = {};   ///< for the positions of spots
  Threads threads = {};  ///< for scattering grains and spots; the result does not depend on them
};

/// Those of the surfaces on which grains, spots and places are seated: more detail shows the same ones, only finer.
inline SweepOptions for_placing(SweepOptions options) {
  options.detail = std::min(options.detail, 1.0);
  return options;
}

}  // namespace pomona
