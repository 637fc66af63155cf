// The same fruit, larger or smaller.
#pragma once

#include "generator/template/template.h"

namespace pomona {

/// All lengths times the factor: curves, meshes, blur, and the sizes and distances of spots and grains, so that
/// everything keeps its place and grains their number. The fine grain of the noise stays as it is, and so do the
/// details of cut faces and how deep ripening and browning go.
Template scaled(Template fruit, double factor);

}  // namespace pomona
