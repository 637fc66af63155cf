// What a sweep may be asked for.
#pragma once

#include "generator/base/parallel.h"
#include "generator/base/random.h"

namespace pomona {

struct SweepOptions {
  double detail = 1.0;   ///< multiplies the number of vertices around and along, 0.1..4
  VariantKey key = {};   ///< where the spots lie
  Threads threads = {};  ///< that scatter grains and spots; no result depends on them
};

}  // namespace pomona
