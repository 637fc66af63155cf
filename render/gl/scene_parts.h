// Which part of the fruit each pixel of a scene's picture shows, found on the CPU.
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.h"
#include "render/plate/part_map.h"

namespace pomona {

/// Looked at in the middle of each pixel: the part of the vertex with the largest share in the foremost triangle. All
/// solids are taken to have the part names of the first.
PartMap scene_parts(const Scene& scene, int width, int height);

/// The scene's view, so that what fills a picture fills a box within it instead. Pixels, y down.
View view_within(const View& view, const glm::dvec2& picture, const glm::dvec2& low, const glm::dvec2& high);

/// Of what lies as far away as the view's target.
double pixels_per_metre(const View& view, double picture_height);

}  // namespace pomona
