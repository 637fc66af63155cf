// The parts that a section shows only as its rim.
#pragma once

#include "generator/template/template.h"
#include "render/picture/section_parts.h"

namespace pomona {

/// The part on the outside of each outer surface, by the surface's name.
OutsideParts outside_parts(const Template& fruit);

}  // namespace pomona
