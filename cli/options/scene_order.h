// The order of a scene, completed from the scene's file, and the options to compose it.
#pragma once

#include "generator/order/order.h"
#include "generator/scene/compose_options.h"
#include "generator/scene/scene_file.h"
#include "render/deliver/delivered.h"

namespace pomona {

/// Completes the order by the scene's seed and style; the style's path starts at the scene's folder.
Order completed(Order order, const SceneDescription& scene);

/// The options to compose the scene. Templates are searched as on the command line.
ComposeOptions compose_options(const Order& order, const DeliveryProgress& progress);

}  // namespace pomona
