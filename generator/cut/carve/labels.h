// Which parts of an arranged fruit lie inside the knife.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/carve/arrangement.h"

namespace pomona {

/// The winding number of the knife around each part (facet[f].mesh.triangle) of each triangle of the fruit.
std::vector<std::vector<int>> windings_of_knife(const Arrangement& all, const ExactPoints& places);

}  // namespace pomona
