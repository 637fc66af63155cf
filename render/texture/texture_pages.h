// Pages: textures that many solids share, so that an engine draws each solid at once and binds few textures.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "render/texture/bake.h"

namespace pomona {

/// The places of solids' textures on pages.
struct PageLayout {
  struct Place {
    std::size_t page = 0;
    glm::ivec2 corner{0};  ///< texels; multiples of a block of mip levels
  };
  std::vector<Place> of_texture;
  std::vector<glm::ivec2> pages;  ///< their sizes: sides are powers of two, up to max_texture_side
};

/// Places rectangles, the highest first, in rows from the top left; a page is as small as it can be, and there are
/// several only where the largest is too small. \param sizes of the textures, texels; 0 x 0 where there is none.
PageLayout page_layout(std::span<const glm::ivec2> sizes);

/// The solids with their texels on pages "NAME", "NAME-2", ... \param layout of their textures, in this order; it may
/// go on. All solids have the same kinds of maps.
std::vector<BakedSolid> on_pages(std::span<const BakedSolid* const> solids, const PageLayout& layout,
                                 const std::string& name);

}  // namespace pomona
