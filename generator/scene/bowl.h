// A turned bowl as a template: it is swept, cut and drawn like any fruit.
#pragma once

#include "generator/scene/scene_file.h"

namespace pomona {

/// One surface around the axis whose front faces air; it closes upon itself on the axis.
Template bowl_template(const BowlDescription& bowl);

/// The bowl as a solid, in its place.
Solid bowl_solid(const BowlDescription& bowl);

}  // namespace pomona
