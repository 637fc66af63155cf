// An exploded view: pieces moved apart, so that the inside is visible.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// Moves every instance away from the middle of all, until its centre is `factor` times as far from there; 1 moves
/// nothing. Pieces keep their size and do not turn. The view is fitted again.
Scene exploded(Scene scene, double factor);

}  // namespace pomona
