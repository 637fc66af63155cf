// Copies a template and its drawing under another name, to start from.
#pragma once

#include <filesystem>
#include <string>

#include "cli/sketch/starting_sketch.h"

namespace pomona {

/// \param original a template that reads well.
/// \param name of the new fruit.
/// \returns its texts; no SVG if the curves stand in the template itself.
/// \throws Error (usage) for a template of meshes, whose files would have to be copied; else as read_template().
StartingSketch copied_fruit(const std::filesystem::path& original, const std::string& name);

}  // namespace pomona
