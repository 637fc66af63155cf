// Looks at the stages of a cut, for benches that time them and oracles that check them.
#pragma once

#include <string_view>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/section/segments.h"
#include "generator/knife/cut_planes.h"

namespace pomona {

/// Told by cut() as it goes along; never from two threads at a time. What it is shown lives as long as the call.
class CutObserver {
 public:
  virtual ~CutObserver() = default;

  /// A stage is done. Closed knives take the stage "carve" one after another.
  virtual void took(std::string_view /*stage*/, double /*milliseconds*/) {}

  /// Where surfaces pass through planes and strokes, plane by plane.
  virtual void sees(const CutPlanes& /*planes*/, const std::vector<std::vector<CutSegment>>& /*segments*/) {}

  /// What planes and strokes have cut, and then what each closed knife has.
  virtual void sees(const CutPlanes& /*planes*/, const Cutting& /*cutting*/) {}
};

}  // namespace pomona
