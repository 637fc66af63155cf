// Boxes in layers: which boxes of earlier layers each one meets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/mesh/box.h"

namespace pomona {

class EarlierBoxes {
 public:
  static constexpr int no_layer = -1;

  /// \param layer of each box; boxes of no layer meet nothing.
  EarlierBoxes(std::span<const Box<float>> box, std::span<const int> layer);

  /// The boxes of earlier layers that have a point in common with this one, in any order.
  std::span<const std::uint32_t> of(std::uint32_t box) const;

 private:
  std::vector<std::uint32_t> earlier_;
  std::vector<std::uint32_t> begin_;  ///< per box: its first among `earlier_`
};

}  // namespace pomona
