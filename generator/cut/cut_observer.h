// Observes the stages of a cut, for benches that measure them and oracles that check them.
#pragma once

#include <string_view>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/section/segments.h"
#include "generator/knife/cut_planes.h"

namespace pomona {

/// cut() calls these functions, never from two threads at a time. The arguments live only as long as the call.
class CutObserver {
 public:
  virtual ~CutObserver() = default;

  /// A stage is done. Closed knives take the stage "carve" one after another.
  virtual void took(std::string_view /*stage*/, double /*milliseconds*/) {}

  /// The cut segments of planes and strokes, plane by plane.
  virtual void sees(const CutPlanes& /*planes*/, const std::vector<std::vector<CutSegment>>& /*segments*/) {}

  /// The result of planes and strokes, and then the result of each closed knife.
  virtual void sees(const CutPlanes& /*planes*/, const Cutting& /*cutting*/) {}
};

}  // namespace pomona
