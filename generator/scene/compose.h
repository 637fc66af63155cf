// Composes a scene: from a scene file to placed, coloured pieces.
#pragma once

#include <vector>

#include "generator/diffusion/diffuser.h"
#include "generator/scene/make_parts.h"
#include "generator/scene/scene.h"

namespace pomona {

struct Composition {
  Scene scene;
  ComposeReport report;
};

/// The parts at their poses, the dishes' first, then one per item; seen as the scene says.
Scene placed(const SceneDescription& scene, SceneParts parts, const std::vector<Pose>& poses);

/// All of it: parts, then poses from the scene's layout file or by settling.
Composition compose(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options);

}  // namespace pomona
