// The direction of a style's light, relative to the viewer.
#pragma once

#include "render/picture/view_frame.h"
#include "render/style/style.h"

namespace pomona {

/// The unit vector towards the light, in the scene. `azimuth` is measured from behind the viewer (negative = left), and
/// `elevation` from the table, radians.
glm::dvec3 light_direction(const ViewFrame& frame, double azimuth, double elevation);

/// The same for the light of a style.
glm::dvec3 light_direction(const View& view, const LightStyle& light);

}  // namespace pomona
