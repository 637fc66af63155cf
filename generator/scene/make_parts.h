// The parts of a scene: the solids of many cut variants, and dishes, before they are placed.
#pragma once

#include <string>
#include <vector>

#include "generator/diffusion/diffuser.h"
#include "generator/scene/compose_options.h"
#include "generator/scene/scene_file.h"
#include "generator/scene/scene_parts.h"

namespace pomona {

/// Reads everything that the scene names (templates, meshes, the layout), and tests its knives. Returns what the files
/// of dishes leave open, and how it was taken.
/// \throws Error at the place in the scene that names what is missing or wrong.
std::vector<std::string> check_sources(const SceneDescription& scene, const ComposeOptions& options);

/// Grows, cuts and colours all variants, in parallel, and picks their pieces. Without a diffuser the cut faces
/// keep the colours of their rims: for layouts and tests.
SceneParts make_parts(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options);

}  // namespace pomona
