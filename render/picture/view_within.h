// A view with a margin, for a plate's margins and letters.
#pragma once

#include <glm/vec2.hpp>

#include "generator/scene/scene.h"

namespace pomona {

/// The view with which the scene fills a box inside the picture, instead of the whole picture. Pixels, y down.
View view_within(const View& view, const glm::dvec2& picture, const glm::dvec2& low, const glm::dvec2& high);

/// The scale at the distance of the view's target.
double pixels_per_metre(const View& view, double picture_height);

}  // namespace pomona
