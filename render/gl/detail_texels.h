// Solids' details as shaders/detail.glsl reads them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "generator/template/example_tile.h"
#include "render/style/look.h"

namespace pomona {

struct DetailTexels {
  /// The same number for every look: those of the cut faces' details, then those of the skin's. An example's has the
  /// number of its tile's first texel, if the tiles follow these.
  std::vector<glm::vec4> styles;

  /// The tiles of examples, each once, in the order of their texels.
  std::vector<std::shared_ptr<const ExampleTile>> tiles;
};

DetailTexels detail_texels(std::span<const Look> looks);

/// The texels of a tile, level after level from the finest: colour, linear, and the share of its luminance.
std::vector<glm::vec4> tile_texels(const ExampleTile& tile);

/// The styles and behind them the tiles, for one buffer.
std::vector<glm::vec4> all_texels(const DetailTexels& details);

}  // namespace pomona
