// Radiance's pictures of light (.hdr), as archives have environments.
#pragma once

#include <string_view>

#include "render/image/linear_pixels.h"

namespace pomona {

/// Longest row of an .hdr; with half as many rows it takes 400 MB in memory.
constexpr int max_hdr_side = 8192;

bool is_hdr(std::string_view bytes);

/// \param name for messages.
/// \throws Error (bad_data) for what is no .hdr with the usual order of rows (-Y N +X N), or is larger than
/// max_hdr_side wide, or half as high.
LinearImage read_hdr(std::string_view bytes, const std::string& name);

}  // namespace pomona
