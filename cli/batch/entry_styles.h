// The styles of one entry of a batch.
#pragma once

#include "render/style/style.h"

namespace pomona {

struct EntryStyles {
  Style drawn;  ///< of thumbnails and of the colours of vertices
  Style baked;  ///< of textures
};

}  // namespace pomona
