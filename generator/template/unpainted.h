// A template of which only the forms are of interest.
#pragma once

#include "generator/template/template.h"

namespace pomona {

/// Without coats and spots, which take longer to paint than the surfaces under them to sweep. Positions, connectivity
/// and hidden sides of what is swept stay the same.
Template unpainted(Template fruit);

}  // namespace pomona
