// Where a style's light comes from, as seen by the one who looks.
#pragma once

#include "render/picture/view_frame.h"
#include "render/style/style.h"

namespace pomona {

/// Unit, scene: towards what is at `azimuth` from behind the one who looks (negative = left) and at `elevation` above
/// the table. Radians.
glm::dvec3 light_direction(const ViewFrame& frame, double azimuth, double elevation);

/// The same for the light of a style.
glm::dvec3 light_direction(const View& view, const LightStyle& light);

}  // namespace pomona
