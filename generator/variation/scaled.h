// The same fruit, larger or smaller.
#pragma once

#include "generator/template/template.h"

namespace pomona {

/// All lengths times the factor: curves, meshes, blur, and the sizes and distances of spots, grains and what is placed,
/// so that everything keeps its relative place and the number of grains stays. Not scaled: the fine grain of the noise,
/// the details of cut faces, and the depths of ripening and browning.
Template scaled(Template fruit, double factor);

}  // namespace pomona
