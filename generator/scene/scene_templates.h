// The templates that a scene names.
#pragma once

#include <vector>

#include "generator/scene/compose_options.h"
#include "generator/scene/scene_file.h"
#include "generator/template/template.h"

namespace pomona {

/// The template of each entry. The same file is read only once.
/// \throws Error at the place in the scene where a template is named that is missing or wrong, or lacks what the entry
/// asks for.
std::vector<Template> scene_templates(const SceneDescription& scene, const ComposeOptions& options);

}  // namespace pomona
