// Checks whether a scene's knives can cut its fruit, before anything is made.
#pragma once

#include <vector>

#include "generator/base/error.h"
#include "generator/scene/scene_file.h"

namespace pomona {

/// Grows each entry's fruit as drawn, coarsely, and cuts it. \throws Error (bad_data) at the entry whose knives do not
/// fit its fruit, or whose fruit cannot be grown.
void check_cuts(const SceneDescription& scene, const std::vector<Template>& templates);

/// An error of cut() about an entry's knives, with its place in the scene's file.
Error at_entry(const PiecesDescription& pieces, const Error& error);

}  // namespace pomona
