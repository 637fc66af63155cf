// A scene's solids with other colours in their textures.
#pragma once

#include <string>
#include <vector>

#include "render/texture/bake.h"

namespace pomona {

/// The textures of a scene's solids in other colours, on the same atlases.
struct TextureVariant {
  std::string name;
  std::vector<BakedSolid> solids;
};

}  // namespace pomona
