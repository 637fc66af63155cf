// Ink along outlines, sample by sample.
#pragma once

#include <cstdint>
#include <vector>

#include "render/thumbnail/sample_grid.h"

namespace pomona {

struct OutlineWidths {
  double outer = 4;  ///< samples: between pieces, and around them
  double rim = 3;    ///< between a cut face and skin
};

/// Per sample: the owner whose ink lies there, or 0. An owner is a piece and a kind of face, see owner_of().
std::vector<std::uint32_t> outlines(const SampleGrid& grid, const OutlineWidths& widths);

/// What outlines() tells apart: \param instance index into the scene's. \param cut whether it is a cut face.
constexpr std::uint32_t owner_of(std::size_t instance, bool cut) {
  return static_cast<std::uint32_t>(2 * (instance + 1) + (cut ? 1 : 0));
}
constexpr std::size_t instance_of(std::uint32_t owner) { return owner / 2 - 1; }

}  // namespace pomona
