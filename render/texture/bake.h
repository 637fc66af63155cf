// Baking: a solid's colours, noise and inner lines as a texture, for engines that want few vertices' colours.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/scene/solid.h"
#include "render/picture/image.h"
#include "render/style/style.h"

namespace pomona {

struct BakeOptions {
  int texels = 1024;  ///< along the texture's edge
  int margin = 4;     ///< texels of bleeding around each chart
};

/// A solid with texture coordinates; vertices are doubled along chart borders.
struct BakedSolid {
  Solid solid;
  std::vector<glm::vec2> uv;  ///< one per vertex; (0, 0) is the upper left corner of the texture
  Image texture;              ///< sRGB
};

/// The same bytes for the same solid, on any machine. \throws Error (usage) if there are too few texels.
BakedSolid baked(const Solid& solid, const Style& style, const BakeOptions& options = {});

}  // namespace pomona
