// The seats of clusters: spread in the room that an envelope surrounds.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/random.h"
#include "generator/template/law_sketch.h"

namespace pomona {

/// The number of seats, or some more.
double cluster_room(const LawSketch& law);

/// Darts within the envelope, pushed apart until they are about `spacing` from each other. Which they are is drawn once
/// for all variants, so that all have as many; each variant then turns them about the axis and shifts each by the law's
/// jitter. The key of seed 0 does neither.
std::vector<glm::dvec3> cluster_seats(const LawSketch& law, VariantKey key);

}  // namespace pomona
