// Inner surfaces that lie outside the fruit, because a curve is drawn beyond the skin.
#pragma once

#include <string>
#include <vector>

#include "generator/surface/bodies.h"

namespace pomona {

/// A warning for each inner surface of which a tenth or more lies outside all bodies. A surface may touch the skin, or
/// leave it a little. No warnings if no body is closed. \param bodies of these surfaces.
std::vector<std::string> stray_warnings(const DiffusionSurfaces& surfaces, const Bodies& bodies);

}  // namespace pomona
