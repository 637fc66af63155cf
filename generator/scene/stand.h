// A whole fruit on the table, for pictures.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// The scene moved up or down, so that its lowest point is on the ground, which takes shadows. The view moves along.
/// A single fruit that nobody has turned yet and that is twice as high as wide lies down, as table_pose() lays it, and
/// is seen anew from where it was seen.
Scene standing(Scene scene);

}  // namespace pomona
