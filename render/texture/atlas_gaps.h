// What no chart of an atlas owns.
#pragma once

#include "render/image/image.h"
#include "render/texture/uv_atlas.h"

namespace pomona {

/// Gives it the mean of the atlas around it, so that the coarsest mip levels look like the whole.
void fill_gaps(Image& image, const Atlas& atlas);

}  // namespace pomona
