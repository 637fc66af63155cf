// A view with room around what fills it, for a plate's margins and letters.
#pragma once

#include <glm/vec2.hpp>

#include "generator/scene/scene.h"

namespace pomona {

/// `view`, so that what fills a picture fills a box within it instead. Pixels, y down.
View view_within(const View& view, const glm::dvec2& picture, const glm::dvec2& low, const glm::dvec2& high);

/// Of what lies as far away as the view's target.
double pixels_per_metre(const View& view, double picture_height);

}  // namespace pomona
