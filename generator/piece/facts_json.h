// Facts of a piece as JSON, for lists of pieces and the records of batches.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// Volume, density, mass, centre, inertia, box, triangles, whether the piece is closed or a crumb, and of which placed
/// instances it is if the fruit has any: docs/reference/formats.md.
nlohmann::ordered_json facts_json(const Solid& solid);

/// The same and, if the fruit has organs (organs.h), `organs` with the volume and the mass of each.
nlohmann::ordered_json facts_with_organs_json(const Solid& solid);

}  // namespace pomona
