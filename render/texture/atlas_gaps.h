// The parts of an atlas that no chart owns.
#pragma once

#include "render/image/image.h"
#include "render/texture/uv_atlas.h"

namespace pomona {

/// Fills them with the mean of the atlas around them, so that the coarsest mip levels look like the whole.
void fill_gaps(Image& image, const Atlas& atlas);

}  // namespace pomona
