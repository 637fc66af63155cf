// Knives as users write them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "generator/knife/knife.h"

namespace pomona {

/// An example of every knife there is, as users write them: "half, across, ..., peel:2mm".
std::string knives_as_written();

/// Reads "half", "across", "plane:NX,NY,NZ,D", "wedges:N", "slices:4mm", "slices:8", "dice:12mm", "sticks:6mm",
/// "crinkle:6mm", "stroke:FILE.svg#id,scale=2mm", "ball:24mm", "core:18mm", "bite:40mm", "revolve:FILE.svg#id",
/// "peel:2mm", and their options (docs/commands.md). Files are looked for from `folder`.
/// \throws Error (usage) that says what a knife looks like; of strokes and profiles also those of read_stroke.h.
Knife parse_knife(std::string_view text, const std::filesystem::path& folder = {});

}  // namespace pomona
