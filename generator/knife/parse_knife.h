// Knives as users write them.
#pragma once

#include <filesystem>
#include <string_view>

#include "generator/knife/knife.h"

namespace pomona {

/// Reads "half", "wedges:6", "slices:4mm", "core:18mm,depth=4cm" and all others of knife_kinds.h. Files are looked for
/// from `folder`.
/// \throws Error (usage) that says what a knife looks like; of strokes and profiles also those of read_stroke.h.
Knife parse_knife(std::string_view text, const std::filesystem::path& folder = {});

}  // namespace pomona
