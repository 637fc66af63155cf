// A list of pieces as JSON, for --pieces.
#pragma once

#include <cstdint>
#include <string>

#include "generator/scene/scene.h"

namespace pomona {

/// docs/reference/formats.md, "Piece list".
std::string piece_list(const Scene& scene);

}  // namespace pomona
