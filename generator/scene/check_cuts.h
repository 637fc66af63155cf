// Whether a scene's knives can cut its fruit, found out before anything is made.
#pragma once

#include <vector>

#include "generator/base/error.h"
#include "generator/scene/scene_file.h"

namespace pomona {

/// Grows each entry's fruit as drawn, coarsely, and cuts it. \throws Error (bad_data) at the entry whose knives cannot
/// be laid at its fruit, or whose fruit cannot be grown.
void check_cuts(const SceneDescription& scene, const std::vector<Template>& templates);

/// What cut() says of an entry's knives, as a mistake in the scene's file.
Error at_entry(const PiecesDescription& pieces, const Error& error);

}  // namespace pomona
