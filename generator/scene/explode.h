// Pieces moved apart, so that one can look inside.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// Every instance away from the middle of all, until its centre is `factor` times as far from there: 1 leaves all in
/// place. Pieces keep their size and do not turn. The view is fitted anew.
Scene exploded(Scene scene, double factor);

}  // namespace pomona
