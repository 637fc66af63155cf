// An order of a scene: what the scene's own file says of it, and how the scene is composed to it.
#pragma once

#include "generator/order/order.h"
#include "generator/scene/compose_options.h"
#include "generator/scene/scene_file.h"
#include "render/deliver/delivered.h"

namespace pomona {

/// What the order leaves open, the scene says: its seed and its style, whose path starts at the scene's folder.
Order completed(Order order, const SceneDescription& scene);

/// How the scene is composed. Templates are looked for as on the command line.
ComposeOptions compose_options(const Order& order, const DeliveryProgress& progress);

}  // namespace pomona
