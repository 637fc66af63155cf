// A template without paint, if only its shapes are needed.
#pragma once

#include "generator/template/template.h"

namespace pomona {

/// The template without coats and spots, because painting them takes longer than sweeping. The positions, triangles and
/// hidden sides of the swept surfaces do not change.
Template unpainted(Template fruit);

}  // namespace pomona
