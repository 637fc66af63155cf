// A solid's details as shaders/detail.glsl reads them.
#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "render/style/look.h"

namespace pomona {

/// The same number of texels for every look: those of the cut faces' details, then those of the skin's.
std::vector<glm::vec4> detail_texels(const Look& look);

}  // namespace pomona
