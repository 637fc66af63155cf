// A whole fruit on the table, for pictures.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// The scene moved up or down so that its lowest point is on the ground, which takes shadows. The view moves with it. A
/// single fruit that has not been turned and is at least twice as high as wide lies down, in its table_pose(), and the
/// view is fitted again from the same direction.
Scene standing(Scene scene);

}  // namespace pomona
