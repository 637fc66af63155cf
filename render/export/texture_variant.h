// A scene's solids with other colours in their textures.
#pragma once

#include <string>
#include <vector>

#include "render/texture/bake.h"

namespace pomona {

/// The solids of a scene once more in other colours, on the same atlases.
struct TextureVariant {
  std::string name;
  std::vector<BakedSolid> solids;
};

}  // namespace pomona
