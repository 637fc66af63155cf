// Which parts a section shows as its rim alone.
#pragma once

#include "generator/template/template.h"
#include "render/picture/section_parts.h"

namespace pomona {

/// By the name of each of the fruit's outer surfaces, the part that is its outside.
OutsideParts outside_parts(const Template& fruit);

}  // namespace pomona
