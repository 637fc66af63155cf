// Assets as files: .pomona, byte by byte in docs/reference/asset.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "render/page/asset.h"

namespace pomona {

/// \param made_by "pomona 0.3.0, seed 2"; a note for people.
/// \param effort of zlib, 1 (fast) to 9 (few bytes)
std::string write_asset(const Asset& asset, const std::string& made_by, int effort = 9);

/// \param file for messages
/// \throws Error (bad_data) for bytes that are no asset, end early, or have indices outside their range. Sizes are
/// checked before memory is allocated.
Asset read_asset(std::string_view bytes, const std::filesystem::path& file);

}  // namespace pomona
