// Inner surfaces that are not inside: a curve drawn past the skin.
#pragma once

#include <string>
#include <vector>

#include "generator/surface/bodies.h"

namespace pomona {

/// A warning for each surface of which a tenth or more lies in no body; one may touch the skin, or leave it by a
/// trifle. Nothing where no body is closed. \param bodies of these surfaces.
std::vector<std::string> stray_warnings(const DiffusionSurfaces& surfaces, const Bodies& bodies);

}  // namespace pomona
