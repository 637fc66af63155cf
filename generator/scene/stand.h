// A whole fruit on the table, for pictures.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// The scene moved up or down, so that its lowest point is on the ground, which takes shadows. The view moves along.
Scene standing(Scene scene);

}  // namespace pomona
