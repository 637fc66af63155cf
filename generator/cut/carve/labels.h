// Which parts of an arranged fruit lie inside the knife.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/cut/carve/arrangement.h"

namespace pomona {

/// Per triangle of the fruit, per part of it (facet[f].mesh.triangle): how often the knife winds around it.
std::vector<std::vector<int>> windings_of_knife(const Arrangement& all, const ExactPlaces& places);

}  // namespace pomona
