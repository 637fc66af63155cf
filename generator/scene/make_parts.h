// From what a scene file says to solids: many cut variants, and dishes; where they lie comes later.
#pragma once

#include "generator/diffusion/diffuser.h"
#include "generator/scene/compose_options.h"
#include "generator/scene/scene_file.h"
#include "generator/scene/scene_parts.h"

namespace pomona {

/// Reads all that the scene names, templates, meshes and the layout, and tries its knives.
/// \throws Error at the place in the scene that names what is missing or wrong.
void check_sources(const SceneDescription& scene, const ComposeOptions& options);

/// Grows, cuts and colours all variants, in parallel, and picks their pieces. Without a diffuser the cut faces
/// keep the colours of their rims: for layouts and tests.
SceneParts make_parts(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options);

}  // namespace pomona
